// A HIP path as a file: the header `x,y,z` or, for a hand that holds a body, `x,y,z,qw,qx,qy,qz`; then a row a tick.
// Units: angstrom; the quaternion turns the body from its orientation in the molecule's file.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

struct HipPath {
  std::vector<PointA> places;
  std::vector<Quat> orientations;  ///< of length 1, as many as places; empty: the file has none

  std::size_t size() const { return places.size(); }
  PoseA at(std::size_t k) const { return {places[k], orientations.empty() ? kNoRotation : orientations[k]}; }
};

/// The poses in the file, in order (number_rows.h). Quaternions of any finite length but zero are taken and brought to
/// length 1; another one is a Problem. Places may be "nan" and "inf": a tracker must accept them.
Expected<HipPath> readHipPath(const std::filesystem::path& file);

}  // namespace moltact
