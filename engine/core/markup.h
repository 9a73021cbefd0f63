// Escapes text for HTML and SVG. Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/printable.h"

namespace moltact {

/// Escapes text for use between tags and in attributes: characters that could form a tag become entities, and
/// unprintable bytes are replaced (printable.h).
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
