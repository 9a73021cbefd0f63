// Makes text from outside (names, titles, paths, messages that quote them) safe to show: no sequence in it controls a
// terminal, reorders the text beside it, or begins a line of its own. Usable on every thread but the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/utf8.h"

namespace moltact {

inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  ///< U+FFFD, shown in place of a harmful piece

/// Whether a code point controls the display: C0 and C1 controls except tab and line end, DEL, and characters that
/// change the direction of the surrounding text (embeddings, overrides, isolates).
constexpr bool steersTerminal(std::uint32_t code) {
  return (code < 0x20 && code != '\t' && code != '\n') || (code >= 0x7F && code < 0xA0) ||
         (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

/// Calls keep(bytes) for each harmless piece of the text and harmful(code, valid) for each harmful code point, in
/// order; `also` says which other code points are harmful.
template <class Keep, class Harmful, class Also>
void splitHarmful(std::string_view text, Keep&& keep, Harmful&& harmful, Also&& also) {
  std::size_t kept = 0, at = 0;
  const auto keepUpToHere = [&] {
    if (at > kept) keep(text.substr(kept, at - kept));
  };
  while (at < text.size()) {
    const CodePoint c = firstCodePoint(text.substr(at));
    if (c.valid && !steersTerminal(c.code) && !also(c.code)) {
      at += c.bytes;
      continue;
    }
    keepUpToHere();
    harmful(c.code, c.valid);
    kept = at += c.bytes;
  }
  keepUpToHere();
}

/// The text with U+FFFD in place of each code point that controls a terminal and each byte that is not UTF-8. Line ends
/// and tabs stay.
inline std::string printable(std::string_view text) {
  std::string out;
  splitHarmful(
      text, [&](std::string_view piece) { out += piece; }, [&](std::uint32_t, bool) { out += kReplacement; },
      [](std::uint32_t) { return false; });
  return out;
}

/// The same on one line: a line end or a tab within becomes a space.
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
