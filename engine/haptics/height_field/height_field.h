// The picture of a scanning tip: one height for each node of a square raster. Plain data, immutable once complete; any
// thread. Units: angstrom. The scan's own axes are x along a line, y from line to line, and z up from the substrate,
// toward the tip. The first node is the origin, at the height of the substrate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/units.h"

namespace moltact {

/// The position of a scan in the molecule's space.
struct ScanFrame {
  Vec3 origin_A{0.0};              ///< the first node on the substrate
  Quat orientation = kNoRotation;  ///< rotates the scan's axes into the molecule's; of unit length

  Vec3 toMolecule(const Vec3& scan_A) const { return origin_A + orientation * scan_A; }
  Vec3 toScan(const Vec3& molecule_A) const { return glm::conjugate(orientation) * (molecule_A - origin_A); }
};

struct HeightField {
  ScanFrame frame;
  int columns = 0, rows = 0;  ///< nodes along x and y; at least 2 each in a valid field
  double spacing_A = 1.0;     ///< between neighbouring nodes, positive
  /// Of the tip's apex above the substrate, at least 0; line by line from y = 0, each from x = 0. The tracker measures
  /// at the same heights.
  std::vector<double> heights_A;
  std::vector<std::int32_t> atoms;  ///< the atom that stops the tip at each node; -1: the substrate

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  double at(int column, int row) const { return heights_A[index(column, row)]; }
  double width_A() const { return spacing_A * (columns - 1); }
  double depth_A() const { return spacing_A * (rows - 1); }
};

}  // namespace moltact
