// A number as a person reads it, alone or with its unit: "0,43 N" in German, "0.43 N" in English, with a no-break space
// (U+00A0) between the two. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/language/units.h"

namespace moltact {

/// How many digits a number has.
struct Digits {
  enum class Kind : std::uint8_t { Usual, Decimals, Significant, Plain } kind = Kind::Usual;
  int count = 0;
};

/// So many behind the decimal sign. For a quantity the count is meant in the code's unit, so that where a dimension is
/// shown in a unit of which a hundred are one of the code's there are two fewer; for a unit that the place asks for
/// (`in`) it is meant in that unit.
constexpr Digits decimals(int count) { return {Digits::Kind::Decimals, count}; }
/// So many that count, never with an exponent: 0.25, 4.2, 120 for two.
constexpr Digits significant(int count) { return {Digits::Kind::Significant, count}; }
/// As many as it takes, six that count at most: 1.4, 2, 0.125, 1e9.
constexpr Digits plain(int most = 6) { return {Digits::Kind::Plain, most}; }

struct QuantityOptions {
  Digits digits{};  ///< default: the decimals of the unit's line in units.cpp
  std::string_view
      in;  ///< a unit of that dimension in the place of the shown one: "ms" for a time; none of its: the shown one
};

/// The value (in the code's unit) in the unit that is shown, and that unit. A number that is not finite is "–".
std::string quantityText(double value, Dimension dimension, QuantityOptions options = {});
std::string quantityText(double value, Dimension dimension, Digits digits);
/// A value in the unit of that symbol, as an author or a task has it; shown in that of its dimension. A unit that is
/// not known stands as it is.
std::string quantityIn(double value, std::string_view symbol, Digits digits);

/// The same without the unit, for a table or an axis that names it once.
std::string quantityNumber(double value, Dimension dimension, QuantityOptions options = {});
std::string quantityNumber(double value, Dimension dimension, Digits digits);

/// A number without a unit.
std::string numberText(double value, Digits digits = plain());

/// The symbol of the unit that is shown: "Å", "N".
std::string_view unitText(Dimension dimension);

enum class DecimalSign : std::uint8_t { OfLanguage, Point, Comma };

/// The sign that the person prefers (default: that of the language in use).
void setDecimalSign(DecimalSign sign) noexcept;
/// '.' or ','.
char decimalSign() noexcept;

/// A number that a person typed, with a point: "1,76" gives "1.76". Where the decimal sign is a point, a comma before
/// exactly three digits may separate thousands and stays: "1,760".
std::string numberAsTyped(std::string text);

/// Prose of an author, with the spaces between a number and a unit made no-break ones. The number stays as it was
/// written.
std::string withUnitsKept(const std::string& text);

}  // namespace moltact
