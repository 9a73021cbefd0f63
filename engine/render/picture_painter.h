// Draws antialiased shapes into a picture in memory. Plain data; usable on every thread. Units: pixel, from the upper
// left corner.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "engine/render/picture.h"
#include "engine/render/view_scene.h"

namespace moltact {

class PicturePainter {
 public:
  explicit PicturePainter(Picture& picture) : picture_(picture) {}

  void blend(int x, int y, const Colour& colour, double alpha) {
    if (x < 0 || y < 0 || x >= picture_.width_px || y >= picture_.height_px) return;
    std::uint8_t* at = picture_.rgb.data() + 3 * (std::size_t(y) * std::size_t(picture_.width_px) + std::size_t(x));
    const auto a = float(std::clamp(alpha, 0.0, 1.0));
    for (int k = 0; k < 3; ++k)
      at[k] = std::uint8_t(std::lround(glm::mix(float(at[k]), 255.0f * std::clamp(colour[k], 0.0f, 1.0f), a)));
  }

  /// Fills a shape given by its signed distance (negative inside), with antialiased edges.
  template <class Distance>
  void fill(glm::dvec2 low, glm::dvec2 high, const Colour& colour, double alpha, Distance&& distance) {
    for (int y = int(std::floor(low.y)) - 1; y <= int(std::ceil(high.y)) + 1; ++y)
      for (int x = int(std::floor(low.x)) - 1; x <= int(std::ceil(high.x)) + 1; ++x)
        if (const double in = 0.5 - distance(glm::dvec2(x + 0.5, y + 0.5)); in > 0.0)
          blend(x, y, colour, alpha * std::min(1.0, in));
  }

  void box(glm::dvec2 low, glm::dvec2 high, double corner, const Colour& colour, double alpha) {
    const glm::dvec2 middle = 0.5 * (low + high), half = 0.5 * (high - low) - corner;
    fill(low, high, colour, alpha, [&](const glm::dvec2& p) {
      const glm::dvec2 d = glm::abs(p - middle) - half;
      return glm::length(glm::max(d, glm::dvec2(0.0))) + std::min(std::max(d.x, d.y), 0.0) - corner;
    });
  }

  void disc(const glm::dvec2& middle, double radius, const Colour& colour, double alpha) {
    fill(middle - radius, middle + radius, colour, alpha,
         [&](const glm::dvec2& p) { return glm::distance(p, middle) - radius; });
  }

  void line(const glm::dvec2& a, const glm::dvec2& b, double width, const Colour& colour, double alpha) {
    const glm::dvec2 edge = b - a;
    const double length2 = glm::dot(edge, edge);
    fill(glm::min(a, b) - width, glm::max(a, b) + width, colour, alpha, [&](const glm::dvec2& p) {
      const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
      return glm::distance(p, a + edge * t) - 0.5 * width;
    });
  }

  void triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const Colour& colour, double alpha) {
    const glm::dvec2 corners[] = {a, b, c};
    const double turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0.0 ? -1.0 : 1.0;
    fill(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), colour, alpha, [&](const glm::dvec2& p) {
      double outside = -1e9;
      for (int k = 0; k < 3; ++k) {
        const glm::dvec2 &from = corners[k], edge = corners[(k + 1) % 3] - from;
        outside = std::max(outside, turn * ((p.x - from.x) * edge.y - (p.y - from.y) * edge.x) / glm::length(edge));
      }
      return outside;
    });
  }

 private:
  Picture& picture_;
};

}  // namespace moltact
