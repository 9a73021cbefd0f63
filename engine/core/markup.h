// Text in HTML and SVG. Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/printable.h"

namespace moltact {

/// Text for use between tags and in attributes: characters that could form a tag become entities, and bytes that are no
/// printable text are cleaned (printable.h).
inline std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  return out;
}

}  // namespace moltact
