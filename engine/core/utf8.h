// Decodes and encodes UTF-8 (RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF), one code point at a
// time. Any thread except the haptic one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

/// The code point at the start of a text and its length in bytes. Invalid UTF-8 gives `valid` false and a length of 1;
/// `cut`: the text ends within a sequence that is valid so far.
struct CodePoint {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false, cut = false;
};

inline CodePoint firstCodePoint(std::string_view text) {
  const auto at = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[k])); };
  const std::uint32_t first = at(0);
  if (first < 0x80) return {first, 1, true, false};
  const std::size_t length = first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
  if (length == 0) return {first, 1, false, false};
  std::uint32_t code = first & (0x7Fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if (k == text.size()) return {first, 1, false, true};
    if ((at(k) & 0xC0u) != 0x80u) return {first, 1, false, false};
    code = code << 6 | (at(k) & 0x3Fu);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool sound = code >= kSmallest[length] && code <= 0x10FFFF && (code < 0xD800 || code >= 0xE000);
  return sound ? CodePoint{code, length, true, false} : CodePoint{first, 1, false, false};
}

/// The offset of the first byte that is not valid UTF-8, or npos.
inline std::size_t firstNotUtf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = firstCodePoint(text.substr(at));
    if (!c.valid) return at;
    at += c.bytes;
  }
  return std::string_view::npos;
}

/// The code points of a text; bytes that are not valid UTF-8 are omitted.
inline std::vector<char32_t> charactersOf(std::string_view text) {
  std::vector<char32_t> out;
  while (!text.empty()) {
    const CodePoint c = firstCodePoint(text);
    if (c.valid) out.push_back(c.code);
    text.remove_prefix(c.bytes);
  }
  return out;
}

/// Encodes a code point (at most U+10FFFF) as UTF-8.
inline std::string utf8Of(char32_t c) {
  std::string out;
  const auto add = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c < 0x80) {
    add(c);
  } else if (c < 0x800) {
    add(0xC0 | c >> 6), add(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    add(0xE0 | c >> 12), add(0x80 | (c >> 6 & 0x3F)), add(0x80 | (c & 0x3F));
  } else {
    add(0xF0 | c >> 18), add(0x80 | (c >> 12 & 0x3F)), add(0x80 | (c >> 6 & 0x3F)), add(0x80 | (c & 0x3F));
  }
  return out;
}

/// The number of code points of a text.
inline std::size_t characterCount(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace moltact
