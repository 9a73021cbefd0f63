// Makes external text (names, titles, paths and messages that quote them) safe to display. In the result no sequence
// controls a terminal, reorders adjacent text or starts a new line. Any thread except the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/utf8.h"

namespace moltact {

inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  ///< U+FFFD, replaces a harmful sequence

/// True for a code point that controls the display: C0 and C1 controls except tab and line end, DEL, and characters
/// that change the direction of the surrounding text (embeddings, overrides, isolates).
constexpr bool isTerminalControl(std::uint32_t code) {
  return (code < 0x20 && code != '\t' && code != '\n') || (code >= 0x7F && code < 0xA0) ||
         (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

/// Calls keep(bytes) for each harmless part of the text and harmful(code, valid) for each harmful code point, in order.
/// `also(code)` returns true for further harmful code points.
template <class Keep, class Harmful, class Also>
void splitHarmful(std::string_view text, Keep&& keep, Harmful&& harmful, Also&& also) {
  std::size_t kept = 0, at = 0;
  const auto keepUpToHere = [&] {
    if (at > kept) keep(text.substr(kept, at - kept));
  };
  while (at < text.size()) {
    const CodePoint c = firstCodePoint(text.substr(at));
    if (c.valid && !isTerminalControl(c.code) && !also(c.code)) {
      at += c.bytes;
      continue;
    }
    keepUpToHere();
    harmful(c.code, c.valid);
    kept = at += c.bytes;
  }
  keepUpToHere();
}

/// Replaces each code point that controls a terminal and each byte that is not UTF-8 by U+FFFD. Keeps line ends and
/// tabs.
inline std::string printable(std::string_view text) {
  std::string out;
  splitHarmful(
      text, [&](std::string_view piece) { out += piece; }, [&](std::uint32_t, bool) { out += kReplacement; },
      [](std::uint32_t) { return false; });
  return out;
}

/// The same on one line: line ends and tabs become spaces.
inline std::string oneLine(std::string_view text) {
  std::string out;
  splitHarmful(
      text, [&](std::string_view piece) { out += piece; },
      [&](std::uint32_t code, bool valid) {
        if (valid && (code == '\n' || code == '\t' || code == '\r'))
          out += ' ';
        else
          out += kReplacement;
      },
      [](std::uint32_t code) { return code == '\n' || code == '\t'; });
  return out;
}

}  // namespace moltact
