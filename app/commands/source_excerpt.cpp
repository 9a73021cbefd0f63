#include "app/commands/source_excerpt.h"

#include <algorithm>
#include <vector>

namespace moltact {
namespace {

constexpr std::size_t kWidth = 96;   // columns shown of a long line
constexpr std::size_t kBefore = 64;  // at most this many of them before the caret

/// One code point: its bytes and its width in terminal columns.
struct Letter {
  std::string_view bytes;
  std::size_t places = 1;
};

unsigned codeOf(std::string_view bytes) {
  const auto first = static_cast<unsigned char>(bytes[0]);
  if (bytes.size() == 1) return first;
  unsigned code = first & (0x7Fu >> bytes.size());
  for (const char c : bytes.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

std::size_t placesOf(std::string_view bytes) {
  const unsigned c = codeOf(bytes);
  const auto in = [c](unsigned low, unsigned high) { return c >= low && c <= high; };
  if (in(0x300, 0x36F) || in(0x200B, 0x200F) || in(0x20D0, 0x20FF) || in(0xFE00, 0xFE0F))
    return 0;  // combines with the preceding character
  if (in(0x1100, 0x115F) || in(0x2E80, 0xA4CF) || in(0xAC00, 0xD7A3) || in(0xF900, 0xFAFF) || in(0xFE30, 0xFE6F) ||
      in(0xFF00, 0xFF60) || in(0x1F300, 0x1FAFF))
    return 2;
  return 1;
}

std::vector<Letter> lettersOf(std::string_view line) {
  std::vector<Letter> out;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i + 1;
    while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) ++end;
    const std::string_view bytes = line.substr(i, end - i);
    // Control characters would move the cursor; they are shown as a question mark.
    const auto first = static_cast<unsigned char>(bytes[0]);
    const bool control = bytes.size() == 1 && first != '\t' && (first < 0x20 || first >= 0x7F);
    out.push_back(control || bytes.size() > 4 ? Letter{"?", 1} : Letter{bytes, placesOf(bytes)});
    i = end;
  }
  return out;
}

}  // namespace

std::string sourceExcerpt(std::string_view line, std::size_t column) {
  const std::vector<Letter> letters = lettersOf(line);
  const std::size_t at = std::min(column ? column - 1 : 0, letters.size());
  std::size_t first = 0, last = letters.size();
  if (letters.size() > kWidth) {
    first = at > kBefore ? at - kBefore : 0;
    last = std::min(letters.size(), first + kWidth);
  }
  std::string text = first ? "…" : "", mark = first ? " " : "";
  for (std::size_t i = first; i < last; ++i) {
    text += letters[i].bytes;
    if (i < at) mark += letters[i].bytes == "\t" ? "\t" : std::string(letters[i].places, ' ');
  }
  if (last < letters.size()) text += "…";
  return text + '\n' + mark + "^\n";
}

}  // namespace moltact
