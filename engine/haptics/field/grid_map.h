// Values on the nodes of a box of cubic cells, and their interpolation. Trilinear interpolation, as in AutoDock, has a
// gradient that jumps at the faces of cells. Tricubic interpolation (Catmull–Rom) has a continuous gradient. Haptic
// thread, except gridBoxRound(), for every other thread. Unit: angstrom.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

/// The nodes of a map: `nodes` along each axis, `spacing_A` apart.
struct GridBox {
  Vec3 first_A{0.0};  ///< of node (0, 0, 0)
  double spacing_A = 0.375;
  std::array<int, 3> nodes{};

  std::size_t count() const { return std::size_t(nodes[0]) * std::size_t(nodes[1]) * std::size_t(nodes[2]); }
  /// The index of a node in a map's values: x runs fastest.
  std::size_t index(int i, int j, int k) const {
    return std::size_t(i) + std::size_t(nodes[0]) * (std::size_t(j) + std::size_t(nodes[1]) * std::size_t(k));
  }
  Vec3 node(int i, int j, int k) const { return first_A + spacing_A * Vec3(i, j, k); }
  /// The corners of the part that every interpolation covers: a cubic needs one more cell on each side.
  Vec3 low_A() const { return first_A + Vec3(spacing_A); }
  Vec3 high_A() const { return node(nodes[0] - 2, nodes[1] - 2, nodes[2] - 2); }

  friend bool operator==(const GridBox&, const GridBox&) = default;
};

/// The largest number of nodes of a map; 256 MB in memory.
inline constexpr std::size_t kMaxGridNodes = std::size_t(1) << 26;
inline constexpr double kMinGridSpacing_A = 0.05, kMaxGridSpacing_A = 10.0;

/// The smallest box that covers `low` to `high` in every interpolation. A Problem for a spacing outside of the limits, a
/// corner that is not finite or more nodes than kMaxGridNodes; `low` must not exceed `high`.
Expected<GridBox> gridBoxRound(const Vec3& low, const Vec3& high, double spacing_A);

enum class GridInterpolation : std::uint8_t { Trilinear, Tricubic };

/// A position in a cell.
struct GridCell {
  std::size_t corner = 0;  ///< index of the node before the cell along each axis: (i - 1, j - 1, k - 1)
  Vec3 t{0.0};             ///< from 0 to 1 within the cell
};

/// The cell of a point; none outside of low_A() to high_A().
std::optional<GridCell> gridCell(const GridBox& box, const Vec3& place) noexcept;

struct GridSample {
  double value = 0.0;
  Vec3 gradient{0.0};                 ///< per angstrom
  std::array<double, 6> curvature{};  ///< per square angstrom: xx, yy, zz, xy, xz, yz; 0 unless asked for
};

/// Value and gradient in a cell of `box`. `map` has one value per node.
GridSample gridSample(const GridBox& box, const GridCell& cell, GridInterpolation interpolation,
                      const float* map) noexcept;
/// With the curvature, which is that of the tricubic interpolation in both cases.
GridSample curvedGridSample(const GridBox& box, const GridCell& cell, GridInterpolation interpolation,
                            const float* map) noexcept;

}  // namespace moltact
