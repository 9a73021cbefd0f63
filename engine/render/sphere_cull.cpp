#include "engine/render/sphere_cull.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/saturated.h"

namespace moltact {
namespace {
constexpr float kNothing = std::numeric_limits<float>::infinity();

// The cell of a coordinate from -1 to 1. Spheres close to the eye may extend arbitrarily far beyond the picture.
int cellAt(float place, float cell) { return saturateToInteger<int>((place + 1) / cell); }

// The slopes (sideways over forward) of the two tangents from the eye to a disc with centre (`side`, `depth`).
glm::vec2 tangents(float side, float depth, float radius) {
  const float q = depth * depth - radius * radius;
  const float s = radius * std::sqrt(std::max(0.0f, side * side + q));
  return {(side * depth - s) / q, (side * depth + s) / q};
}
}  // namespace

bool projectSphere(const Projection& projection, const glm::vec3& centre, float radius, DrawnSphere& out, float rim) {
  const float depth = -centre.z;
  if (!(depth - radius > float(projection.depth.near_A))) return false;
  const float widened = radius + rim * depth;
  if (!(depth > widened)) return false;
  const glm::vec2 x = tangents(centre.x, depth, widened) / projection.tan_x;  // exact: Mara and McGuire 2013
  const glm::vec2 y = tangents(centre.y, depth, widened) / projection.tan_y;
  if (x[0] >= 1 || x[1] <= -1 || y[0] >= 1 || y[1] <= -1) return false;
  out.centre = centre;
  out.radius = radius;
  out.low = {x[0], y[0]};
  out.high = {x[1], y[1]};
  return true;
}

void SphereCull::run(std::span<const Sphere> spheres, const SphereBlocks& blocks, const Camera& camera,
                     const Projection& projection, float rim, bool occlusion, std::span<const std::uint8_t> shown) {
  seen_.clear();
  drawn_.clear();
  order_.clear();
  tan_x_ = projection.tan_x;
  tan_y_ = projection.tan_y;
  const glm::dmat3 turn = glm::transpose(glm::mat3_cast(camera.orientation));
  const auto toView = [&](const Vec3& place) {
    return glm::vec3(turn * (place - camera.target.A) - Vec3(0, 0, camera.distance_A));
  };
  const auto project = [&](std::uint32_t i, DrawnSphere& sphere) {
    if (!shown.empty() && !shown[i]) return false;
    const Sphere& b = spheres[i];
    if (!projectSphere(projection, toView(b.centre_A), float(b.radius_A), sphere, rim)) return false;
    sphere.index = i;
    return true;
  };
  DrawnSphere sphere;
  if (!occlusion) {
    for (std::uint32_t i = 0; i < spheres.size(); ++i)
      if (project(i, sphere)) seen_.push_back(sphere);
    sortSeen();
    for (const auto& [depth, k] : order_) drawn_.push_back(seen_[k]);
    atoms_drawn_ = drawn_.size();
    return;
  }

  const std::vector<Near> near = blocksAhead(blocks, projection, rim, toView);
  makeCells(spheres, blocks, near, projection);
  for (const Near& n : near) {
    if (n.boxed && hidden(n.image)) continue;
    // The nearest sphere of a block first, so that it may hide the others.
    found_.clear();
    for (const std::uint32_t i : blocks.of(blocks.blocks()[n.image.index]))
      if (project(i, sphere)) found_.push_back(sphere);
    std::sort(found_.begin(), found_.end(), [](const DrawnSphere& a, const DrawnSphere& b) {
      return -a.centre.z - a.radius < -b.centre.z - b.radius;
    });
    for (const DrawnSphere& s : found_) {
      if (hidden(s)) continue;
      seen_.push_back(s);
      cover(s);
    }
  }
  // A second pass with all covering spheres: most of the remaining ones are still hidden.
  sortSeen();
  atoms_drawn_ = 0;
  for (const auto& [depth, k] : order_) {
    const std::size_t before = drawn_.size();
    emitBoxes(seen_[k]);
    atoms_drawn_ += drawn_.size() > before;
  }
}

// From front to back. Equal depths are ordered by index, so that the picture does not depend on how its spheres were
// found.
void SphereCull::sortSeen() {
  for (std::uint32_t k = 0; k < seen_.size(); ++k) order_.emplace_back(-seen_[k].centre.z - seen_[k].radius, k);
  std::sort(order_.begin(), order_.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : seen_[a.second].index < seen_[b.second].index;
  });
}

template <class ToView>
std::vector<SphereCull::Near> SphereCull::blocksAhead(const SphereBlocks& blocks, const Projection& projection,
                                                      float rim, ToView&& toView) const {
  std::vector<Near> near;
  for (std::uint32_t k = 0; k < blocks.blocks().size(); ++k) {
    const SphereBlocks::Block& block = blocks.blocks()[k];
    Near n;
    n.image.centre = toView(block.centre_A);
    // Rounding to float far away must not make the block smaller than its spheres.
    n.image.radius = float(block.radius_A) * 1.0001f + 1e-6f * glm::length(n.image.centre);
    const float depth = -n.image.centre.z, nearest = depth - n.image.radius;
    if (depth + n.image.radius <= float(projection.depth.near_A)) continue;
    n.boxed = nearest > float(projection.depth.near_A) && depth > n.image.radius + rim * (depth + n.image.radius);
    // A sphere's rim is proportional to its depth; the block uses that of its deepest sphere.
    const float rims = rim * (depth + n.image.radius) / std::max(depth, 1e-6f);
    if (n.boxed && !projectSphere(projection, n.image.centre, n.image.radius, n.image, rims)) continue;
    n.image.index = k;
    near.push_back(n);
  }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return -a.image.centre.z - a.image.radius < -b.image.centre.z - b.image.radius;
  });
  return near;
}

// About eight cells across a sphere: finer cells cost more than they save.
void SphereCull::makeCells(std::span<const Sphere> spheres, const SphereBlocks& blocks, std::span<const Near> near,
                           const Projection& projection) {
  double wide = 0;
  for (const Near& n : near) {
    const Sphere& one = spheres[blocks.of(blocks.blocks()[n.image.index]).front()];
    wide += one.radius_A / std::max(double(-n.image.centre.z), projection.depth.near_A);
  }
  const double mean_px = near.empty() ? 0 : wide / double(near.size()) / tan_x_ * projection.width_px;
  cell_px_ = std::clamp(saturateToInteger<int>(mean_px / 8), 1, 24);
  cells_x_ = (projection.width_px + cell_px_ - 1) / cell_px_;
  cells_y_ = (projection.height_px + cell_px_ - 1) / cell_px_;
  cell_x_ = 2.0f * float(cell_px_) / float(projection.width_px);
  cell_y_ = 2.0f * float(cell_px_) / float(projection.height_px);
  covered_.assign(std::size_t(cells_x_) * cells_y_, kNothing);
  row_.resize(std::size_t(cells_x_) + 1);
  row_before_.resize(row_.size());
}

SphereCull::Span SphereCull::inSight(const DrawnSphere& s, int row) const {
  const float nearest = -s.centre.z - s.radius;
  const float* cells = covered_.data() + std::size_t(row) * cells_x_;
  int first = std::max(0, cellAt(s.low.x, cell_x_)), last = std::min(cells_x_ - 1, cellAt(s.high.x, cell_x_));
  while (first <= last && cells[first] < nearest) ++first;
  while (first <= last && cells[last] < nearest) --last;
  return {first, last};
}

// Combines rows of cells into boxes as long as little is drawn unnecessarily.
void SphereCull::emitBoxes(const DrawnSphere& s) {
  const int y0 = std::max(0, cellAt(s.low.y, cell_y_)), y1 = std::min(cells_y_ - 1, cellAt(s.high.y, cell_y_));
  int from = 0, to = -1, needed = 0;
  Span box{0, -1};
  const auto close = [&] {
    if (to < from) return;
    DrawnSphere piece = s;
    piece.low = glm::max(s.low, glm::vec2(float(box.first) * cell_x_, float(from) * cell_y_) - 1.0f);
    piece.high = glm::min(s.high, glm::vec2(float(box.last + 1) * cell_x_, float(to + 1) * cell_y_) - 1.0f);
    drawn_.push_back(piece);
  };
  for (int y = y0; y <= y1; ++y) {
    const Span span = inSight(s, y);
    const int cells = span.last - span.first + 1;
    if (cells > 0 && to >= from) {
      const Span both{std::min(box.first, span.first), std::max(box.last, span.last)};
      const int area = (both.last - both.first + 1) * (y - from + 1);
      if (area - needed - cells <= 3 + area / 5) {
        box = both;
        to = y;
        needed += cells;
        continue;
      }
    }
    close();
    from = y;
    to = cells > 0 ? y : y - 1;
    box = span;
    needed = std::max(cells, 0);
  }
  close();
}

bool SphereCull::hidden(const DrawnSphere& s) const {
  const int y0 = std::max(0, cellAt(s.low.y, cell_y_)), y1 = std::min(cells_y_ - 1, cellAt(s.high.y, cell_y_));
  for (int y = y0; y <= y1; ++y)
    if (const Span span = inSight(s, y); span.first <= span.last) return false;
  return true;
}

// A cell is covered if the rays through its four corners all hit the sphere, because the image of a sphere is convex.
// Within such a cell the front is nowhere deeper than at the deepest corner, because 1 / depth of a convex front is
// concave.
void SphereCull::cover(const DrawnSphere& s) {
  const int x0 = std::max(0, saturateToInteger<int>(std::ceil((s.low.x + 1) / cell_x_))),
            x1 = std::min(cells_x_, cellAt(s.high.x, cell_x_));
  const int y0 = std::max(0, saturateToInteger<int>(std::ceil((s.low.y + 1) / cell_y_))),
            y1 = std::min(cells_y_, cellAt(s.high.y, cell_y_));
  if (x1 <= x0) return;
  const float r2 = s.radius * s.radius, depth = -s.centre.z;
  for (int y = y0; y <= y1; ++y) {
    const float ray_y = (float(y) * cell_y_ - 1) * tan_y_;
    for (int x = x0; x <= x1; ++x) {
      const float ray_x = (float(x) * cell_x_ - 1) * tan_x_;
      const float a = ray_x * ray_x + ray_y * ray_y + 1;
      const float k = (ray_x * s.centre.x + ray_y * s.centre.y + depth) / a;
      const float qx = s.centre.x - k * ray_x, qy = s.centre.y - k * ray_y, qz = k - depth;
      const float h = r2 - qx * qx - qy * qy - qz * qz;
      row_[std::size_t(x)] = h > 0 ? k - std::sqrt(h / a) : kNothing;
    }
    if (y > y0) {
      float* cells = covered_.data() + std::size_t(y - 1) * cells_x_;
      for (int x = x0; x < x1; ++x) {
        const float deepest = std::max(std::max(row_[x], row_[x + 1]), std::max(row_before_[x], row_before_[x + 1]));
        cells[x] = std::min(cells[x], deepest);
      }
    }
    std::swap(row_, row_before_);
  }
}

}  // namespace moltact
