#include "engine/results/anonymous_text.h"

#include <algorithm>
#include <array>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// Bytes of other than ASCII characters count as letters: "Zoë" is one word.
bool inWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool isWordAt(std::string_view text, std::size_t at, std::size_t length) {
  const bool begins = at == 0 || !inWord(text[at - 1]) || !inWord(text[at]);
  const std::size_t end = at + length;
  return begins && (end == text.size() || !inWord(text[end]) || !inWord(text[end - 1]));
}

std::size_t letterCount(std::string_view word) {
  return std::size_t(std::count_if(word.begin(), word.end(), [](char c) {
    return inWord(c) && (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // the first byte of each character
  }));
}

}  // namespace

NameCover::NameCover(const std::map<std::string, std::string>& codes) {
  constexpr std::size_t kFewest = 2;
  for (const auto& [name, code] : codes) {
    const std::string all = lower(name);
    if (!trimmed(all).empty()) longest_first_.push_back({all, code});
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= all.size(); ++at) {
      if (at < all.size() && inWord(all[at])) continue;
      const std::string word = all.substr(begin, at - begin);
      if (word != all && letterCount(word) >= kFewest) longest_first_.push_back({word, code});
      begin = at + 1;
    }
  }
  std::stable_sort(longest_first_.begin(), longest_first_.end(),
                   [](const Hidden& a, const Hidden& b) { return a.name.size() > b.name.size(); });
}

std::string NameCover::covered(std::string_view text) const {
  const std::string small = lower(std::string(text));
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto hidden = std::find_if(longest_first_.begin(), longest_first_.end(), [&](const Hidden& h) {
      return small.compare(at, h.name.size(), h.name) == 0 && isWordAt(small, at, h.name.size());
    });
    if (hidden == longest_first_.end()) {
      out += text[at++];
      continue;
    }
    out += hidden->code;
    at += hidden->name.size();
  }
  return out;
}

bool mentions(std::string_view text, std::string_view name) {
  const std::string all = lower(std::string(text)), wanted = lower(std::string(name));
  if (wanted.empty()) return false;
  for (std::size_t at = all.find(wanted); at != std::string::npos; at = all.find(wanted, at + 1))
    if (isWordAt(all, at, wanted.size())) return true;
  return false;
}

bool isMeasurement(std::string_view text) {
  text = trimmed(text);
  constexpr std::string_view kOfNumbers = "0123456789.,+-eE ";
  std::size_t end = 0;
  bool digit = false;
  for (; end < text.size() && kOfNumbers.find(text[end]) != std::string_view::npos; ++end)
    digit = digit || (text[end] >= '0' && text[end] <= '9');
  constexpr std::array<std::string_view, 14> kUnits{"",   "Å",  "A", "nm",     "pm",       "N", "mN",
                                                    "pN", "ms", "s", "kJ/mol", "kcal/mol", "%", "°"};
  return digit && std::find(kUnits.begin(), kUnits.end(), trimmed(text.substr(end))) != kUnits.end();
}

std::string wordsLeftOut(const std::string& text) {
  if (text.empty() || isMeasurement(text)) return text;
  std::size_t words = 0;
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\n'; };
  for (std::size_t at = 0; at < text.size(); ++at) words += !blank(text[at]) && (at == 0 || blank(text[at - 1]));
  return trnf("({0} word left out)", "({0} words left out)", words, words);
}

}  // namespace moltact
