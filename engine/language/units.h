// Every unit that the program knows: which quantity it measures, how it counts, and where it is used. To show forces in
// another unit, its line is marked kShown in the place of the newton's. Plain data; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

/// What a number counts. In brackets: the unit in which the code counts.
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
  Other        ///< the program shows none, an author's prose may
};

enum UnitUse : std::uint8_t {
  kKept = 0,     ///< only kept on one line with its number where it stands in prose
  kWritten = 1,  ///< an author may write it in a lesson
  kShown = 2     ///< the unit in which the program shows quantities of this dimension; one for each
};

struct Unit {
  std::string_view symbol;
  Dimension dimension;
  double in_code_units;
  int use;           ///< of UnitUse
  int decimals = 0;  ///< of kShown: how many a number has where its place asks for no others
};

/// Shown and written ones first within a dimension.
std::span<const Unit> units();

/// The unit in which quantities of the dimension are shown. Null for None and Other.
const Unit* shownUnit(Dimension dimension);

/// The unit of that symbol within the dimension; null where there is none.
const Unit* unitNamed(std::string_view symbol, Dimension dimension);

}  // namespace moltact
