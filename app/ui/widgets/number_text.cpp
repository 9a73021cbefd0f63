#include "app/ui/widgets/number_text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace moltact {
namespace {

bool g_comma = false;

bool digit(char c) { return c >= '0' && c <= '9'; }

std::string exchanged(std::string text, char from, char to) {
  for (std::size_t k = 1; k + 1 < text.size(); ++k)
    if (text[k] == from && digit(text[k - 1]) && digit(text[k + 1])) text[k] = to;
  return text;
}

bool wordly(char c) {
  return digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '/' || c == '\\';
}

// Whether the point at `k`, which has digits on both sides, is a decimal point.
bool decimalPoint(const std::string& text, std::size_t k) {
  std::size_t low = k, high = k + 1;
  while (low > 0 && digit(text[low - 1])) --low;
  while (high < text.size() && digit(text[high])) ++high;
  if (low > 0 && (wordly(text[low - 1]) || text[low - 1] == '.')) return false;
  if (high == text.size()) return true;
  return !wordly(text[high]) && !(text[high] == '.' && high + 1 < text.size() && wordly(text[high + 1]));
}

constexpr std::array<std::string_view, 26> kUnits{"Å",  "Å²", "Å³",  "nm",   "µm",  "mm", "cm",  "m", "N",
                                                  "mN", "pN", "N/m", "N/mm", "s",   "ms", "min", "h", "%",
                                                  "°",  "°C", "K",   "g",    "kDa", "Da", "kg",  "Hz"};

}  // namespace

void setDecimalComma(bool on) { g_comma = on; }

std::string localNumbers(std::string text) { return g_comma ? exchanged(std::move(text), '.', ',') : text; }

std::string localProse(std::string text) {
  if (!g_comma) return text;
  for (std::size_t k = 1; k + 1 < text.size(); ++k)
    if (text[k] == '.' && digit(text[k - 1]) && digit(text[k + 1]) && decimalPoint(text, k)) text[k] = ',';
  return text;
}

std::string withUnitsKept(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    out += text[k];
    if (!digit(text[k]) || k + 1 >= text.size() || text[k + 1] != ' ') continue;
    const std::size_t begin = k + 2, end = std::min(text.find_first_of(" \n,;:!?)", begin), text.size());
    std::string_view word(text.data() + begin, end - begin);
    if (word.ends_with('.')) word.remove_suffix(1);
    if (std::find(kUnits.begin(), kUnits.end(), word) == kUnits.end()) continue;
    out += "\u00a0";
    ++k;
  }
  return out;
}

std::string plainNumbers(std::string text) {
  // Where a point is preferred, a comma before three digits may part thousands; any other is a decimal one all the
  // same.
  const std::size_t comma = text.find(',');
  std::size_t digits = 0;
  while (comma != std::string::npos && comma + 1 + digits < text.size() && digit(text[comma + 1 + digits])) ++digits;
  return g_comma || digits != 3 ? exchanged(std::move(text), ',', '.') : text;
}

std::string clockText(int whole_s) {
  char text[24];
  std::snprintf(text, sizeof text, "%d:%02d", whole_s / 60, std::abs(whole_s % 60));
  return text;
}

}  // namespace moltact
