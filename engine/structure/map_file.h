// Maps in AutoGrid's format (.map): six lines of text with names, spacing, numbers of intervals and centre, then one value
// per node, x fastest. Any thread except the haptic one. Units: angstrom; the values are in kcal/mol, of the electrostatic
// map per elementary charge.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/field/grid_map.h"

namespace moltact {

struct MapFile {
  GridBox box;
  std::vector<float> values;  ///< box.count()
  std::string molecule;       ///< the file of the molecule, as the map names it
};

/// The largest file that is read: 1 GiB.
inline constexpr std::size_t kMaxMapBytes = std::size_t(1) << 30;
/// The largest amount of a value (unit: kcal/mol); AutoGrid's own limit is 1e5.
inline constexpr double kMaxMapValue = 1e30;

/// Returns a Problem for a line that is not AutoGrid's, a value that is not finite, and fewer or more values than the
/// header says. Also for a spacing or a number of nodes outside the limits of grid_map.h.
Expected<MapFile> readMap(std::string_view text, const std::string& file);
Expected<MapFile> readMapFile(const std::filesystem::path& file);

/// The smallest box round `low` to `high` that AutoGrid's header can state: an even number of intervals, and a centre of
/// three decimals. A Problem as gridBoxRound().
Expected<GridBox> mapBoxRound(const Vec3& low, const Vec3& high, double spacing_A);

/// The text of a map of such a box. `stem` names the files of the same calculation: STEM.maps.fld. Values beyond 1e5
/// become 1e5, as in AutoGrid's maps, and have four decimals.
std::string mapText(const GridBox& box, std::span<const float> values, std::string_view stem,
                    std::string_view molecule);

/// The text of STEM.maps.fld, which lists the maps STEM.NAME.map for viewers, and of STEM.maps.xyz with the box's corners.
std::string mapFieldText(const GridBox& box, std::string_view stem, std::string_view molecule,
                         std::span<const std::string> names);
std::string mapCornersText(const GridBox& box);

/// How well the values of a map follow those of another one.
struct MapAgreement {
  std::size_t points = 0;    ///< compared; the other members are 0 without any
  double correlation = 0.0;  ///< Pearson's; 0 if one map is constant
  double factor = 0.0;       ///< of the other map that fits best (least squares)
  double rms = 0.0;          ///< of the difference that remains (unit: that of the map)
  double largest = 0.0;      ///< the largest amount of that difference
};

/// Compares `map` with `factor` times `other` at the nodes where `counts` holds. All spans have the same size.
MapAgreement mapAgreement(std::span<const float> map, std::span<const float> other,
                          const std::function<bool(std::size_t node)>& counts);

}  // namespace moltact
