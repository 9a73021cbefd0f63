// A bounding box of drawn pixels. Plain data.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/render/projection.h"

namespace moltact {

/// Columns and rows from the lower left corner; x1 and y1 are exclusive.
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool empty() const { return x1 <= x0 || y1 <= y0; }
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }

  /// The bounding box of both.
  PixelBox joined(const PixelBox& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1), std::max(y1, other.y1)};
  }
  /// Enlarges the box by `by` pixels on each side, within a picture of this size; an empty box stays empty.
  PixelBox grown(int by, int width_px, int height_px) const {
    if (empty()) return {};
    return {std::max(0, x0 - by), std::max(0, y0 - by), std::min(width_px, x1 + by), std::min(height_px, y1 + by)};
  }
  PixelBox times(int factor) const { return {x0 * factor, y0 * factor, x1 * factor, y1 * factor}; }
};

/// Accumulates the bounding box of spheres and points in the camera's axes.
class PixelBoxBuilder {
 public:
  explicit PixelBoxBuilder(const Projection& projection) : projection_(projection) {}

  void add(const glm::vec3& centre, float radius) {
    const float nearest = -centre.z - radius;
    any_ = true;
    if (!(nearest > float(projection_.depth.near_A))) {  // a sphere at the eye may cover the whole picture
      low_ = glm::vec2(-1.0f);
      high_ = glm::vec2(1.0f);
      return;
    }
    // The image of the sphere lies within the image of its box.
    for (const float depth : {nearest, nearest + 2 * radius}) {
      const glm::vec2 scale = 1.0f / (depth * glm::vec2(projection_.tan_x, projection_.tan_y));
      low_ = glm::min(low_, (glm::vec2(centre) - radius) * scale);
      high_ = glm::max(high_, (glm::vec2(centre) + radius) * scale);
    }
  }

  /// The box in a picture of the projection's size, enlarged by `margin_px`.
  PixelBox box(int margin_px) const {
    if (!any_) return {};
    const glm::vec2 size(projection_.width_px, projection_.height_px);
    const glm::vec2 low = (glm::clamp(low_, -1.0f, 1.0f) * 0.5f + 0.5f) * size,
                    high = (glm::clamp(high_, -1.0f, 1.0f) * 0.5f + 0.5f) * size;
    return {std::max(0, int(std::floor(low.x)) - margin_px), std::max(0, int(std::floor(low.y)) - margin_px),
            std::min(projection_.width_px, int(std::ceil(high.x)) + margin_px),
            std::min(projection_.height_px, int(std::ceil(high.y)) + margin_px)};
  }

 private:
  Projection projection_;
  glm::vec2 low_{1.0f}, high_{-1.0f};
  bool any_ = false;
};

}  // namespace moltact
