#include "engine/results/csv_row.h"

#include <cstdint>
#include <cstdio>
#include <string_view>

#include "engine/core/printable.h"

namespace moltact {
namespace {

// The characters that begin a formula, including full-width and small forms, which some spreadsheets convert.
bool beginsFormula(std::uint32_t c) {
  constexpr std::u32string_view kSigns = U"=+-@\uFF1D\uFF0B\uFF0D\uFF20\uFE66\uFE62\uFE63\uFE6B";
  return kSigns.find(char32_t(c)) != kSigns.npos;
}

// Characters that a spreadsheet may strip before it checks for a formula: blanks of any width, invisible marks, and
// replacements of control characters.
bool mayBeCutOff(std::uint32_t c) {
  return c == ' ' || c == '\t' || c == '\n' || c == 0xA0 || c == 0xAD || c == 0x34F || c == 0x61C || c == 0x1680 ||
         c == 0x180E || (c >= 0x2000 && c <= 0x200F) || c == 0x2028 || c == 0x2029 || c == 0x202F ||
         (c >= 0x205F && c <= 0x2065) || c == 0x3000 || c == 0x3164 || c == 0xFEFF || c == 0xFFA0 || c == 0xFFFD;
}

// After these, a new cell may begin if the spreadsheet uses another separator than the comma, as in many countries.
bool maySeparate(std::uint32_t c) { return c == ';' || c == '\t' || c == '\n'; }

// Inserts an apostrophe before everything that a spreadsheet could take for a formula.
std::string harmless(std::string_view text) {
  std::string out;
  bool at_begin = true;
  std::size_t begin = 0;  // start of the possible cell, in `out`
  while (!text.empty()) {
    const CodePoint c = firstCodePoint(text);
    const bool odd =
        out.empty() && (c.code == '\t' || c.code == '\n' || c.code == 0xFFFD);  // no normal text begins this way
    if (odd || (at_begin && beginsFormula(c.code))) out.insert(begin, "'");
    at_begin = at_begin && mayBeCutOff(c.code);
    out += text.substr(0, c.bytes);
    text.remove_prefix(c.bytes);
    if (maySeparate(c.code)) {
      at_begin = true;
      begin = out.size();
    }
  }
  return out;
}

std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find("\r\n", at)) != std::string::npos;) text.erase(at, 1);
  text = harmless(printable(text));
  if (text.find_first_of(",\"\n;\t") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string cellNumber(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

}  // namespace

CsvRow::~CsvRow() { out_ += "\r\n"; }

void CsvRow::text(const std::string& cell) { raw(quoted(cell)); }

void CsvRow::value(double v, int digits) { raw(cellNumber(v, digits)); }

void CsvRow::raw(const std::string& cell) {
  if (!first_) out_ += ',';
  first_ = false;
  out_ += cell;
}

}  // namespace moltact
