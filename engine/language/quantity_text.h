// Formats numbers for people, alone or with a unit: "0,43 N" in German, "0.43 N" in English, with a no-break space
// (U+00A0) between number and unit. Any thread except the haptic one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/language/units.h"

namespace moltact {

/// The number of digits of a formatted number.
struct Digits {
  enum class Kind : std::uint8_t { Usual, Decimals, Significant, Plain } kind = Kind::Usual;
  int count = 0;
};

/// A fixed number of decimals. For a quantity, `count` refers to the code's unit and is adapted to the shown unit: two
/// decimals fewer if that is a hundredth of the code's unit. With QuantityOptions::in it refers to that unit.
constexpr Digits decimals(int count) { return {Digits::Kind::Decimals, count}; }
/// A number of significant digits, never with an exponent: 0.25, 4.2, 120 for two.
constexpr Digits significant(int count) { return {Digits::Kind::Significant, count}; }
/// As many digits as needed, at most six significant ones: 1.4, 2, 0.125, 1e9.
constexpr Digits plain(int max_digits = 6) { return {Digits::Kind::Plain, max_digits}; }

struct QuantityOptions {
  Digits digits{};  ///< default: the decimals of the unit's row in units.cpp
  /// A unit of the dimension that replaces the shown one: "ms" for a time. Another text is ignored.
  std::string_view in;
};

/// Formats a value (in the code's unit) in the shown unit, with its symbol. A value that is not finite becomes "–".
std::string quantityText(double value, Dimension dimension, QuantityOptions options = {});
std::string quantityText(double value, Dimension dimension, Digits digits);
/// Formats a value given in the unit `symbol`, as used by authors and tasks, in the unit of shownInstead().
std::string quantityIn(double value, std::string_view symbol, Digits digits);
/// Formats an energy between atoms or in their springs: "-26.2 kcal/mol". It keeps this unit, that of its literature,
/// whatever unit the user chose for other quantities.
std::string energyBetweenAtoms(double energy_kcal_mol, Digits digits);
/// The shown unit of the dimension of `symbol`. Null where `symbol` is kept. These are units that are unknown or never
/// shown as a choice (pN), and energies, which tasks give between atoms and in the unit of their literature (kcal/mol).
const Unit* shownInstead(std::string_view symbol);

/// The same without the unit, for a table or axis that states it once.
std::string quantityNumber(double value, Dimension dimension, QuantityOptions options = {});
std::string quantityNumber(double value, Dimension dimension, Digits digits);

/// Formats a number without a unit.
std::string numberText(double value, Digits digits = plain());

/// The symbol of the shown unit: "Å", "N".
std::string_view unitText(Dimension dimension);

enum class DecimalSign : std::uint8_t { OfLanguage, Point, Comma };

/// Sets the user's preferred sign (default: that of the language).
void setDecimalSign(DecimalSign sign) noexcept;
/// '.' or ','.
char decimalSign() noexcept;

/// Converts a number typed by a user to a decimal point: "1,76" becomes "1.76". If the decimal sign is a point, a comma
/// before exactly three digits may be a thousands separator and is kept: "1,760".
std::string numberAsTyped(std::string text);

/// Replaces the space between a number and its unit in an author's prose by a no-break space. The number itself is
/// unchanged.
std::string withUnitsKept(const std::string& text);

}  // namespace moltact
