// The table of all units: the quantity that each measures, its conversion and its use; and the set of units in which
// quantities are shown. Any thread except the haptic one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace moltact {

/// The quantity that a number measures, with the unit used in the code.
enum class Dimension : std::uint8_t {
  None,        ///< a plain number
  Length,      ///< in the molecule (Å)
  Force,       ///< at the hand (N)
  Time,        ///< (s)
  Stiffness,   ///< in the device's space (N/mm)
  HandLength,  ///< in the device's space (mm)
  Angle,       ///< (°)
  Share,       ///< a part of a whole (1; shown in per cent)
  Frequency,   ///< (Hz)
  Energy,      ///< (J); a unit per mole applies to one contact times Avogadro's number
  Other        ///< occurs only in an author's prose
};
inline constexpr std::size_t kDimensions = std::size_t(Dimension::Other) + 1;

enum UnitUse : std::uint8_t {
  kProseOnly = 0,     ///< only kept on one line with its number in prose
  kWritten = 1,       ///< allowed in lessons
  kNamed = 2,         ///< suggested in messages about a missing unit and in the authors' reference
  kShowable = 4,      ///< allowed in a UnitSet
  kInPreferences = 8  ///< offered in the preferences if another unit of its dimension is offered too
};

struct Unit {
  std::string_view symbol;
  Dimension dimension;
  double in_code_units;  ///< size of one such unit in the code's unit
  int use;               ///< combination of UnitUse
  int decimals = 0;      ///< default number of decimals, for kShowable
};

std::span<const Unit> units();

/// Finds a unit by symbol within a dimension; null if there is none.
const Unit* unitNamed(std::string_view symbol, Dimension dimension);
/// Finds a unit by symbol in all dimensions; null if there is none.
const Unit* unitNamed(std::string_view symbol);

/// A dimension whose unit the user can choose: a row in units.cpp.
struct OfferedDimension {
  Dimension dimension;
  std::string_view name;  ///< in files: "length"
  const char* title;      ///< on the screen, untranslated (N_): "Lengths in the molecule"
};

/// The dimensions with at least two units of kInPreferences, in display order.
std::span<const OfferedDimension> offeredDimensions();
/// The symbols of the units offered for a dimension: "Å", "nm", "pm".
std::vector<std::string_view> offeredUnits(Dimension dimension);

/// The symbol of the unit used in the code: "Å", "N", "s", "N/mm". Empty for None, Share and Other.
std::string_view codeUnit(Dimension dimension);

/// The kNamed units of a dimension, for messages to authors: "Å" and "nm".
std::vector<std::string_view> namedUnits(Dimension dimension);

/// The shown unit of each dimension. A new set contains the defaults: see kOwnUnits in units.cpp.
class UnitSet {
 public:
  UnitSet();
  /// Sets the unit of a dimension. Returns false and changes nothing if it has no kShowable unit of that symbol.
  bool choose(Dimension dimension, std::string_view symbol);
  /// The same, with the dimension by its name in offeredDimensions().
  bool choose(std::string_view dimension_name, std::string_view symbol);
  /// Null for None and Other.
  const Unit* of(Dimension dimension) const { return units_[std::size_t(dimension)]; }

 private:
  std::array<const Unit*, kDimensions> units_{};
};

/// Sets the units in which all quantities are shown.
void setShownUnits(const UnitSet& units) noexcept;

/// The shown unit of a dimension. Null for None and Other.
const Unit* shownUnit(Dimension dimension) noexcept;

}  // namespace moltact
