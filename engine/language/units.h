// Every unit that the program knows: which quantity it measures, how it counts, and where it is used; and the set of
// units in which quantities are shown. Any thread but the haptic one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace moltact {

/// The quantity that a number measures. In brackets: the unit in which the code counts.
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
  Energy,      ///< (J); a unit per mole is that of one contact times Avogadro's number
  Other        ///< the program shows none, an author's prose may
};
inline constexpr std::size_t kDimensions = std::size_t(Dimension::Other) + 1;

enum UnitUse : std::uint8_t {
  kProseOnly = 0,     ///< only kept on one line with its number where it stands in prose
  kWritten = 1,       ///< an author may write it in a lesson
  kNamed = 2,         ///< messages and the authors' reference name it where a unit is missing
  kShowable = 4,      ///< a UnitSet may hold it
  kInPreferences = 8  ///< Preferences offer it, where another of its dimension is offered too
};

struct Unit {
  std::string_view symbol;
  Dimension dimension;
  double in_code_units;
  int use;           ///< of UnitUse
  int decimals = 0;  ///< of kShowable: how many a number has where its place asks for no others
};

std::span<const Unit> units();

/// The unit of that symbol within the dimension; null where there is none.
const Unit* unitNamed(std::string_view symbol, Dimension dimension);
/// The unit of that symbol, whatever it measures; null where there is none.
const Unit* unitNamed(std::string_view symbol);

/// Under which a choice of its unit is kept and offered. A dimension that has one is a row in units.cpp.
struct OfferedDimension {
  Dimension dimension;
  std::string_view name;  ///< in files: "length"
  const char* title;      ///< on the screen, N_: "Lengths in the molecule"
};

/// Those that have two units or more which are kInPreferences, in the order in which they are offered.
std::span<const OfferedDimension> offeredDimensions();
/// Their symbols: "Å", "nm", "pm".
std::vector<std::string_view> offeredUnits(Dimension dimension);

/// The symbol of the unit in which the code counts: "Å", "N", "s", "N/mm". Empty for None, Share and Other.
std::string_view codeUnit(Dimension dimension);

/// The units that a message names to an author, kNamed: "Å" and "nm".
std::vector<std::string_view> namedUnits(Dimension dimension);

/// In which unit quantities of each dimension are shown. A new one is the program's own: see kOwnUnits in units.cpp.
class UnitSet {
 public:
  UnitSet();
  /// False, and nothing is changed, where the dimension has no kShowable unit of that symbol.
  bool choose(Dimension dimension, std::string_view symbol);
  /// The same by the dimension's name among offeredDimensions().
  bool choose(std::string_view dimension_name, std::string_view symbol);
  /// Null for None and Other.
  const Unit* of(Dimension dimension) const { return units_[std::size_t(dimension)]; }

 private:
  std::array<const Unit*, kDimensions> units_{};
};

/// From here on every quantity is shown in these.
void setShownUnits(const UnitSet& units) noexcept;

/// The unit in which quantities of the dimension are shown. Null for None and Other.
const Unit* shownUnit(Dimension dimension) noexcept;

}  // namespace moltact
