#include "engine/lesson/quantity.h"

#include <charconv>
#include <cmath>
#include <string>

#include "engine/language/catalogue.h"
#include "engine/lesson/source_text.h"

namespace moltact {
namespace {

Problem problemAt(std::string_view text, std::size_t offset, std::string message, std::string remedy = {}) {
  return {{}, 0, characterCount(text.substr(0, offset)) + 1, std::move(message), std::move(remedy)};
}

struct Number {
  double value = 0.0;
  std::size_t length = 0;  // its length in bytes
};

Expected<Number> leadingNumber(std::string_view whole, std::size_t from) {
  const std::string_view text = whole.substr(from);
  Number out;
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(first, text.data() + text.size(), out.value);
  out.length = static_cast<std::size_t>(end - text.data());
  if (error == std::errc::result_out_of_range)
    return problemAt(whole, from, trf("'{0}' is too large or too small a number", text.substr(0, out.length)));
  if (error != std::errc{} || !std::isfinite(out.value))
    return problemAt(whole, from, text.empty() ? tr("a number is missing") : trf("'{0}' is not a number", text));
  if (text.substr(out.length).starts_with(','))
    return problemAt(whole, from + out.length, tr("a comma in a number"), tr("write the decimal sign as a point: 0.3"));
  return out;
}

// "Å or nm", in the language in use.
std::string unitsFor(Dimension dimension) {
  std::string out;
  for (const std::string_view symbol : namedUnits(dimension))
    out = out.empty() ? std::string(symbol) : trf("{0} or {1}", out, symbol);
  return out;
}

// The names of a dimension in messages to authors, in English.
struct DimensionWords {
  const char *name, *no_unit;
};

DimensionWords wordsOf(Dimension dimension) {
  switch (dimension) {
    case Dimension::Length:
      return {N_("a length"), N_("'{0}' is no unit of length")};
    case Dimension::Force:
      return {N_("a force"), N_("'{0}' is no unit of force")};
    case Dimension::Time:
      return {N_("a time"), N_("'{0}' is no unit of time")};
    case Dimension::Stiffness:
      return {N_("a stiffness"), N_("'{0}' is no unit of stiffness")};
    case Dimension::Angle:
      return {N_("an angle"), N_("'{0}' is no unit of angle")};
    case Dimension::Share:
      return {N_("a share"), N_("'{0}' is no unit of a share")};
    case Dimension::None:
    case Dimension::HandLength:
    case Dimension::Frequency:
    case Dimension::Energy:
    case Dimension::Other:
      break;
  }
  return {N_("a number"), N_("'{0}' is no unit")};
}

/// Normalizes a unit: non-breaking blanks, and the angstrom as an A with a combining ring.
std::string plainUnit(std::string_view symbol) {
  std::string out(symbol);
  for (const std::string_view blank :
       {std::string_view("\u00A0"), std::string_view("\u202F"), std::string_view("\u2009")})
    while (out.starts_with(blank)) out = std::string(stripped(std::string_view(out).substr(blank.size())));
  for (std::size_t at; (at = out.find("A\u030A")) != std::string::npos;) out.replace(at, 3, "\u00C5");
  for (std::size_t at; (at = out.find("\u212B")) != std::string::npos;) out.replace(at, 3, "\u00C5");
  return out;
}

/// The factor of the unit from `unit_at` to the end of `whole`. A Problem if the unit is missing, unknown or of another
/// dimension.
Expected<double> factorOf(std::string_view whole, std::size_t number_at, std::size_t unit_at, Dimension dimension) {
  const std::string_view number = whole.substr(number_at, unit_at - number_at);
  const std::string_view written = stripped(whole.substr(unit_at));
  const std::string symbol = plainUnit(written);
  const std::string wanted = unitsFor(dimension);
  if (symbol.empty()) return problemAt(whole, number_at, trf("'{0}' needs a unit: {1}", stripped(number), wanted));
  for (const Unit& u : units()) {
    if (!(u.use & kWritten) || u.symbol != symbol) continue;
    if (u.dimension == dimension) return u.in_code_units;
    return problemAt(whole, number_at,
                     trf("'{0}' is {1}, but {2} is needed: {3}", stripped(whole.substr(number_at)),
                         tr(dimensionName(u.dimension)), tr(dimensionName(dimension)), wanted));
  }
  const std::size_t at = static_cast<std::size_t>(written.data() - whole.data());
  return problemAt(whole, at, trf(wordsOf(dimension).no_unit, symbol), trf("write {0}", wanted));
}

}  // namespace

const char* dimensionName(Dimension dimension) { return wordsOf(dimension).name; }

Expected<double> parseQuantity(std::string_view text, Dimension dimension) {
  const std::size_t from = static_cast<std::size_t>(stripped(text).data() - text.data());
  const auto number = leadingNumber(text, from);
  if (!number) return number.problem();
  const auto factor = factorOf(text, from, from + number->length, dimension);
  if (!factor) return factor.problem();
  const double value = number->value * *factor;
  if (!std::isfinite(value)) return problemAt(text, from, trf("'{0}' is too large", stripped(text)));
  return value;
}

Expected<QuantityRange> parseRange(std::string_view text, Dimension dimension) {
  const std::size_t to = text.find(" to ");
  if (to == std::string_view::npos)
    return problemAt(text, 0, trf("'{0}' is not a range", stripped(text)), tr("write it as '0.2 N to 0.6 N'"));
  const auto high_problem_shift = characterCount(text.substr(0, to + 4));
  auto high = parseQuantity(text.substr(to + 4), dimension);
  if (!high) {
    Problem p = high.problem();
    p.column += high_problem_shift;
    return p;
  }
  // In "0.2 to 0.6 N", the unit applies to both numbers.
  const std::size_t from = static_cast<std::size_t>(stripped(text).data() - text.data());
  const auto low_number = leadingNumber(text.substr(0, to), from);
  if (!low_number) return low_number.problem();
  double low = 0.0;
  if (stripped(text.substr(from + low_number->length, to - from - low_number->length)).empty()) {
    const std::string_view high_text = text.substr(to + 4);
    const auto high_number = leadingNumber(high_text, high_text.find_first_not_of(" \t"));
    const auto factor = factorOf(high_text, 0, high_text.find_first_not_of(" \t") + high_number->length, dimension);
    low = low_number->value * *factor;
  } else {
    const auto parsed = parseQuantity(text.substr(0, to), dimension);
    if (!parsed) return parsed.problem();
    low = *parsed;
  }
  if (low > *high)
    return problemAt(text, from, tr("the range ends below its start"), tr("write the smaller value first"));
  return QuantityRange{low, *high};
}

Expected<double> parseNumber(std::string_view text) {
  const std::size_t from = static_cast<std::size_t>(stripped(text).data() - text.data());
  const auto number = leadingNumber(text, from);
  if (!number) return number.problem();
  const std::size_t after = from + number->length;
  const std::string_view rest = stripped(text.substr(after));
  if (!rest.empty())
    return problemAt(text, static_cast<std::size_t>(rest.data() - text.data()), trf("'{0}' after the number", rest));
  return number->value;
}

}  // namespace moltact
