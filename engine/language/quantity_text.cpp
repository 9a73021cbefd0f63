#include "engine/language/quantity_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr const char* kNoBreakSpace = "\u00a0";
constexpr int kMaxDecimals = 12;

std::atomic<DecimalSign> g_sign{DecimalSign::OfLanguage};

bool digit(char c) { return c >= '0' && c <= '9'; }

std::string decimalsOf(double value, int count) {
  return fmt::format("{:.{}f}", value, std::clamp(count, 0, kMaxDecimals));
}

std::string significantOf(double value, int count) {
  if (value == 0.0) return "0";
  const double rounded = std::strtod(fmt::format("{:.{}e}", value, std::max(count - 1, 0)).c_str(), nullptr);
  return decimalsOf(rounded, count - 1 - int(std::floor(std::log10(std::abs(rounded)) + 1e-9)));
}

std::string withSign(std::string text) {
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);  // no "-0.0"
  if (const char sign = decimalSign(); sign != '.') std::replace(text.begin(), text.end(), '.', sign);
  return text;
}

// Shortens "1e+09" to "1e9".
std::string shortExponent(std::string text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::size_t from = e + 1;
  if (text[from] == '+')
    text.erase(from, 1);
  else
    ++from;  // '-'
  while (from + 1 < text.size() && text[from] == '0') text.erase(from, 1);
  return text;
}

constexpr double kEnormous = 1e15;  // from here on written with an exponent

std::string numberIn(double value, Digits digits, const Unit* unit, bool asked_for) {
  const double factor = unit ? 1.0 / unit->in_code_units : 1.0;
  value *= factor;
  if (!std::isfinite(value)) return "–";  // also if only the conversion overflows
  // Digits beyond the precision of a double would be noise.
  const bool enormous = std::abs(value) >= kEnormous;
  switch (enormous ? Digits::Kind::Usual : digits.kind) {
    case Digits::Kind::Decimals:
      return withSign(decimalsOf(value, digits.count - (asked_for ? 0 : int(std::lround(std::log10(factor))))));
    case Digits::Kind::Significant:
      return withSign(significantOf(value, digits.count));
    case Digits::Kind::Usual:
      if (unit && unit->use & kShowable && !enormous) return withSign(decimalsOf(value, unit->decimals));
      break;
    case Digits::Kind::Plain:
      break;
  }
  return withSign(shortExponent(fmt::format("{:.{}g}", value, digits.kind == Digits::Kind::Plain ? digits.count : 6)));
}

const Unit* unitOf(Dimension dimension, std::string_view in) {
  const Unit* wanted = in.empty() ? nullptr : unitNamed(in, dimension);
  return wanted ? wanted : shownUnit(dimension);
}

}  // namespace

std::string quantityNumber(double value, Dimension dimension, QuantityOptions options) {
  return numberIn(value, options.digits, unitOf(dimension, options.in), !options.in.empty());
}

std::string quantityNumber(double value, Dimension dimension, Digits digits) {
  return quantityNumber(value, dimension, {digits, {}});
}

std::string quantityText(double value, Dimension dimension, QuantityOptions options) {
  const Unit* unit = unitOf(dimension, options.in);
  std::string out = numberIn(value, options.digits, unit, !options.in.empty());
  if (!unit) return out;
  if (unit->symbol != "°") out += kNoBreakSpace;  // the degree sign follows its number directly
  return out += unit->symbol;
}

std::string quantityText(double value, Dimension dimension, Digits digits) {
  return quantityText(value, dimension, {digits, {}});
}

std::string numberText(double value, Digits digits) { return numberIn(value, digits, nullptr, false); }

std::string quantityIn(double value, std::string_view symbol, Digits digits) {
  const Unit* unit = unitNamed(symbol);
  if (const Unit* in_use = shownInstead(symbol))
    return quantityText(
        value * unit->in_code_units, unit->dimension,
        in_use->in_code_units == unit->in_code_units ? QuantityOptions{digits, symbol} : QuantityOptions{digits, {}});
  return numberText(value, digits) + (symbol.empty() ? "" : kNoBreakSpace) + std::string(symbol);
}

std::string energyBetweenAtoms(double energy_kcal_mol, Digits digits) {
  return quantityIn(energy_kcal_mol, "kcal/mol", digits);
}

const Unit* shownInstead(std::string_view symbol) {
  const Unit* unit = unitNamed(symbol);
  if (!unit || !(unit->use & kShowable) || unit->dimension == Dimension::Energy) return nullptr;
  return shownUnit(unit->dimension);
}

std::string_view unitText(Dimension dimension) {
  const Unit* unit = shownUnit(dimension);
  return unit ? unit->symbol : std::string_view{};
}

void setDecimalSign(DecimalSign sign) noexcept { g_sign.store(sign, std::memory_order_relaxed); }

char decimalSign() noexcept {
  switch (g_sign.load(std::memory_order_relaxed)) {
    case DecimalSign::Point:
      return '.';
    case DecimalSign::Comma:
      return ',';
    case DecimalSign::OfLanguage:
      break;
  }
  return *trc("decimal sign", ".") == ',' ? ',' : '.';
}

std::string numberAsTyped(std::string text) {
  const std::size_t comma = text.find(',');
  std::size_t digits = 0;
  while (comma != std::string::npos && comma + 1 + digits < text.size() && digit(text[comma + 1 + digits])) ++digits;
  if (decimalSign() == '.' && digits == 3) return text;
  for (std::size_t k = 1; k + 1 < text.size(); ++k)
    if (text[k] == ',' && digit(text[k - 1]) && digit(text[k + 1])) text[k] = '.';
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
    if (std::none_of(units().begin(), units().end(), [&](const Unit& u) { return u.symbol == word; })) continue;
    out += kNoBreakSpace;
    ++k;
  }
  return out;
}

}  // namespace moltact
