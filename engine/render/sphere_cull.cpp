#include "engine/render/sphere_cull.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/saturated.h"

namespace moltact {
namespace {
constexpr float kNothing = std::numeric_limits<float>::infinity();

// The cell in which a place from -1 to 1 lies. A ball close before the eye reaches as far beyond the picture as one
// likes.
int cellAt(float place, float cell) { return saturateToInteger<int>((place + 1) / cell); }

// The slopes (sideways over ahead) of the two tangents from the eye to a disc; `side` and `depth` are its centre.
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

void SphereCull::run(const BallScene& scene, const Camera& camera, const Projection& projection, float rim,
                     bool occlusion, std::span<const std::uint8_t> shown) {
  seen_.clear();
  drawn_.clear();
  kept_.clear();
  order_.clear();
  tan_x_ = projection.tan_x;
  tan_y_ = projection.tan_y;
  double wide = 0;
  const glm::dmat3 turn = glm::transpose(glm::mat3_cast(camera.orientation));
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    if (!shown.empty() && !shown[i]) continue;
    const Ball& b = scene[i];
    const Vec3 view = turn * (b.centre_A - camera.target.A) - Vec3(0, 0, camera.distance_A);
    DrawnSphere sphere;
    if (!projectSphere(projection, glm::vec3(view), float(b.radius_A), sphere, rim)) continue;
    sphere.index = i;
    order_.emplace_back(-sphere.centre.z - sphere.radius, std::uint32_t(seen_.size()));
    wide += sphere.high.x - sphere.low.x;
    seen_.push_back(sphere);
  }
  std::sort(order_.begin(), order_.end());
  if (!occlusion) {
    for (const auto& [depth, k] : order_) drawn_.push_back(seen_[k]);
    atoms_drawn_ = drawn_.size();
    return;
  }

  // About eight cells across a ball: finer costs more than the drawing that it saves.
  const double mean_px = seen_.empty() ? 0 : wide / double(seen_.size()) * 0.5 * projection.width_px;
  cell_px_ = std::clamp(saturateToInteger<int>(mean_px / 8), 3, 24);
  cells_x_ = (projection.width_px + cell_px_ - 1) / cell_px_;
  cells_y_ = (projection.height_px + cell_px_ - 1) / cell_px_;
  cell_x_ = 2.0f * float(cell_px_) / float(projection.width_px);
  cell_y_ = 2.0f * float(cell_px_) / float(projection.height_px);
  covered_.assign(std::size_t(cells_x_) * cells_y_, kNothing);
  row_.resize(std::size_t(cells_x_) + 1);
  row_before_.resize(row_.size());
  for (const auto& [depth, k] : order_) {
    if (hidden(seen_[k])) continue;
    kept_.push_back(k);
    cover(seen_[k]);
  }
  // Once more with all that covers: of the balls that stay most is still hidden.
  atoms_drawn_ = 0;
  for (const std::uint32_t k : kept_) {
    const std::size_t before = drawn_.size();
    emitBoxes(seen_[k]);
    atoms_drawn_ += drawn_.size() > before;
  }
}

SphereCull::Span SphereCull::inSight(const DrawnSphere& s, int row) const {
  const float nearest = -s.centre.z - s.radius;
  const float* cells = covered_.data() + std::size_t(row) * cells_x_;
  int first = std::max(0, cellAt(s.low.x, cell_x_)), last = std::min(cells_x_ - 1, cellAt(s.high.x, cell_x_));
  while (first <= last && cells[first] < nearest) ++first;
  while (first <= last && cells[last] < nearest) --last;
  return {first, last};
}

// Rows of cells are put together into boxes as long as little is drawn in vain.
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

// A cell is covered where the rays through its four corners all hit the ball, since the image of a ball is convex. Over
// such a cell the front is nowhere deeper than at the deepest corner: 1 / depth of a convex front is concave.
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
