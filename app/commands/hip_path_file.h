// Reads a HIP path from a file: the header `x,y,z` or, with a held body, `x,y,z,qw,qx,qy,qz`; then one row per tick.
// Unit: angstrom. The quaternion rotates the body from its orientation in the molecule's file.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

struct HipPath {
  std::vector<PointA> places;
  std::vector<Quat> orientations;  ///< unit quaternions, one per place; empty: the file has none

  std::size_t size() const { return places.size(); }
  PoseA at(std::size_t k) const { return {places[k], orientations.empty() ? kNoRotation : orientations[k]}; }
};

/// Returns the poses in the order of the file (number_rows.h). Quaternions of any finite length except zero are
/// normalized; others are a Problem. Places may be "nan" and "inf", because trackers must accept them.
Expected<HipPath> readHipPath(const std::filesystem::path& file);

}  // namespace moltact
