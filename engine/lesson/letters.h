// Classifies letters, for words and scripts in a lesson's text. Pure functions; any thread.
#pragma once

#include <string_view>

#include "engine/core/utf8.h"

namespace moltact {

/// Whether it is a letter or digit of any script, and not a blank, punctuation, arrow or mathematical sign.
inline bool isLetter(char32_t c) {
  if (c < 0x80) return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  if (c < 0xC0) return c == 0xAA || c == 0xB5 || c == 0xBA;
  if (c == 0xD7 || c == 0xF7) return false;
  return (c < 0x2000 || c > 0x2BFF) && (c < 0x3000 || c > 0x303F);
}

inline bool beginsWithLetter(std::string_view text) {
  if (text.empty()) return false;
  const CodePoint c = firstCodePoint(text);
  return c.valid && isLetter(c.code);
}

inline bool endsInLetter(std::string_view text) {
  if (text.empty()) return false;
  std::size_t at = text.size() - 1;
  while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) --at;
  return beginsWithLetter(text.substr(at));
}

}  // namespace moltact
