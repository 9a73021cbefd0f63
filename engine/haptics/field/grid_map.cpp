#include "engine/haptics/field/grid_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

using V4 = float __attribute__((vector_size(16)));

V4 load(const float* from) {
  V4 out;
  std::memcpy(&out, from, sizeof out);
  return out;
}

double total(V4 v) { return (double(v[0]) + double(v[1])) + (double(v[2]) + double(v[3])); }

// The weights of four nodes at -1, 0, 1 and 2 for a point at t, after Catmull and Rom, and their derivatives.
struct Cubic {
  explicit Cubic(double s) {
    const float t = float(s);
    value = V4{t * (t * (2 - t) - 1), t * t * (3 * t - 5) + 2, t * (t * (4 - 3 * t) + 1), t * t * (t - 1)} * 0.5f;
    first = V4{t * (4 - 3 * t) - 1, t * (9 * t - 10), t * (8 - 9 * t) + 1, t * (3 * t - 2)} * 0.5f;
    second = V4{2 - 3 * t, 9 * t - 5, 4 - 9 * t, 3 * t - 1};
  }
  V4 value, first, second;
};

template <bool curved>
GridSample cubicAt(const GridBox& box, const GridCell& cell, const float* map) {
  const Cubic x(cell.t.x), y(cell.t.y), z(cell.t.z);
  const float* const corner = map + cell.corner;
  const std::size_t row = std::size_t(box.nodes[0]), slab = row * std::size_t(box.nodes[1]);
  V4 v{}, vy{}, vz{}, vyy{}, vzz{}, vyz{};
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      const V4 r = load(corner + std::size_t(k) * slab + std::size_t(j) * row);
      v += r * (y.value[j] * z.value[k]);
      vy += r * (y.first[j] * z.value[k]);
      vz += r * (y.value[j] * z.first[k]);
      if constexpr (!curved) continue;
      vyy += r * (y.second[j] * z.value[k]);
      vzz += r * (y.value[j] * z.second[k]);
      vyz += r * (y.first[j] * z.first[k]);
    }
  GridSample out;
  const double once = 1.0 / box.spacing_A, twice = once * once;
  out.value = total(v * x.value);
  out.gradient = once * Vec3(total(v * x.first), total(vy * x.value), total(vz * x.value));
  if constexpr (curved)
    out.curvature = {twice * total(v * x.second), twice * total(vyy * x.value), twice * total(vzz * x.value),
                     twice * total(vy * x.first), twice * total(vz * x.first),  twice * total(vyz * x.value)};
  return out;
}

GridSample linearAt(const GridBox& box, const GridCell& cell, const float* map) {
  const std::size_t row = std::size_t(box.nodes[0]), slab = row * std::size_t(box.nodes[1]);
  const float* const near = map + cell.corner + slab + row + 1;
  const double x = cell.t.x, y = cell.t.y, z = cell.t.z;
  double along[2][2], slope[2][2];  // of the edges along x, [z][y]
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j) {
      const float* const at = near + std::size_t(k) * slab + std::size_t(j) * row;
      slope[k][j] = double(at[1]) - double(at[0]);
      along[k][j] = double(at[0]) + x * slope[k][j];
    }
  const double y0 = along[0][1] - along[0][0], y1 = along[1][1] - along[1][0];
  const double z0 = along[0][0] + y * y0, z1 = along[1][0] + y * y1;
  const double x0 = slope[0][0] + y * (slope[0][1] - slope[0][0]), x1 = slope[1][0] + y * (slope[1][1] - slope[1][0]);
  return {z0 + z * (z1 - z0), Vec3(x0 + z * (x1 - x0), y0 + z * (y1 - y0), z1 - z0) / box.spacing_A, {}};
}

}  // namespace

Expected<GridBox> gridBoxRound(const Vec3& low, const Vec3& high, double spacing_A) {
  if (!(spacing_A >= kMinGridSpacing_A && spacing_A <= kMaxGridSpacing_A))
    return Problem{{}, 0, 0, tr("the spacing of the grid is not from 0.05 to 10 Å"), tr("0.375 Å is customary")};
  if (!finite(low) || !finite(high))
    return Problem{{}, 0, 0, tr("the grid's box is not finite"), tr("give its centre and its edges in ångström")};
  GridBox box{low - Vec3(spacing_A), spacing_A, {}};
  double count = 1.0;
  Vec3 nodes;
  for (int axis = 0; axis < 3; ++axis) {
    // A cell more or less by rounding is left out.
    nodes[axis] = std::ceil((high[axis] - low[axis]) / spacing_A - 1e-9) + 3.0;
    nodes[axis] = std::max(nodes[axis], 4.0);
    count *= nodes[axis];
  }
  if (!(count <= double(kMaxGridNodes)))
    return Problem{
        {}, 0, 0, tr("the grid would have more than 67 million points"), tr("choose a wider spacing or a smaller box")};
  for (int axis = 0; axis < 3; ++axis) box.nodes[std::size_t(axis)] = int(nodes[axis]);
  return box;
}

std::optional<GridCell> gridCell(const GridBox& box, const Vec3& place) noexcept {
  GridCell cell;
  std::array<int, 3> index{};
  for (int axis = 0; axis < 3; ++axis) {
    const double at = (place[axis] - box.first_A[axis]) / box.spacing_A;
    const int last = box.nodes[std::size_t(axis)] - 2;
    if (!(at >= 1.0 && at <= double(last))) return std::nullopt;
    const int cell_index = std::min(int(at), last - 1);
    if (cell_index < 1) return std::nullopt;  // a box of fewer than four nodes
    index[std::size_t(axis)] = cell_index;
    cell.t[axis] = at - double(cell_index);
  }
  cell.corner = box.index(index[0] - 1, index[1] - 1, index[2] - 1);
  return cell;
}

GridSample gridSample(const GridBox& box, const GridCell& cell, GridInterpolation interpolation,
                      const float* map) noexcept {
  return interpolation == GridInterpolation::Trilinear ? linearAt(box, cell, map) : cubicAt<false>(box, cell, map);
}

GridSample curvedGridSample(const GridBox& box, const GridCell& cell, GridInterpolation interpolation,
                            const float* map) noexcept {
  GridSample out = cubicAt<true>(box, cell, map);
  if (interpolation == GridInterpolation::Trilinear) {
    const GridSample linear = linearAt(box, cell, map);
    out.value = linear.value;
    out.gradient = linear.gradient;
  }
  return out;
}

}  // namespace moltact
