// The widest way from outside to a place in a molecule: the largest ball whose centre comes from open water to a place
// where it touches the target, without overlapping an atom. A grid around the place and the path of greatest bottleneck
// (Dijkstra, maximum of minima): an oracle without trackers, surface places or probes. Every way found is real; a way
// through a gap between two grid points may be missed, so that the result is too small by less than 0.9 of the spacing.
// Units: angstrom.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact::test {

class WidestWay {
 public:
  /// A cube of 2 `reach_A` around `middle_A`. Points that are farther than `kWater_A` from every atom are open water.
  WidestWay(std::span<const Sphere> spheres, Vec3 middle_A, double reach_A, double cell_A)
      : low_A_(middle_A - Vec3(reach_A)), cell_A_(cell_A), side_(1 + int(std::ceil(2.0 * reach_A / cell_A))) {
    clear_A_.assign(std::size_t(side_) * std::size_t(side_) * std::size_t(side_), float(kWater_A + 1.0));
    for (const Sphere& s : spheres) {
      const double grown = s.radius_A + kWater_A + 1.0;
      int from[3], to[3];
      for (int k = 0; k < 3; ++k) {
        from[k] = std::max(0, int(std::ceil((s.centre_A[k] - grown - low_A_[k]) / cell_A)));
        to[k] = std::min(side_ - 1, int(std::floor((s.centre_A[k] + grown - low_A_[k]) / cell_A)));
      }
      for (int x = from[0]; x <= to[0]; ++x)
        for (int y = from[1]; y <= to[1]; ++y)
          for (int z = from[2]; z <= to[2]; ++z) {
            float& clear = clear_A_[index(x, y, z)];
            clear = std::min(clear, float(glm::distance(at(x, y, z), s.centre_A) - s.radius_A));
          }
    }
    best_A_.assign(clear_A_.size(), -1.0f);
    std::priority_queue<std::pair<float, std::uint32_t>> open;
    for (std::size_t i = 0; i < clear_A_.size(); ++i)
      if (clear_A_[i] >= kWater_A) best_A_[i] = clear_A_[i], open.emplace(clear_A_[i], std::uint32_t(i));
    while (!open.empty()) {
      const auto [wide, i] = open.top();
      open.pop();
      if (wide < best_A_[i]) continue;
      const int x = int(i) / (side_ * side_), y = int(i) / side_ % side_, z = int(i) % side_;
      for (const auto& [dx, dy, dz] : kSteps) {
        const int nx = x + dx, ny = y + dy, nz = z + dz;
        if (nx < 0 || ny < 0 || nz < 0 || nx >= side_ || ny >= side_ || nz >= side_) continue;
        const std::size_t n = index(nx, ny, nz);
        if (const float w = std::min(wide, clear_A_[n]); w > 0.0f && w > best_A_[n])
          best_A_[n] = w, open.emplace(w, std::uint32_t(n));
      }
    }
  }

  /// The radius of the largest ball that comes from open water and touches this sphere within 0.35 A, at a place that
  /// `counts`; 0 if none does.
  double to(const Sphere& target, const std::function<bool(const Vec3&)>& counts) const {
    double widest = 0.0;
    for (int x = 0; x < side_; ++x)
      for (int y = 0; y < side_; ++y)
        for (int z = 0; z < side_; ++z) {
          const double wide = best_A_[index(x, y, z)];
          if (wide <= widest) continue;
          const Vec3 p = at(x, y, z);
          if (glm::distance(p, target.centre_A) - target.radius_A - 0.35 <= wide && counts(p)) widest = wide;
        }
    return widest;
  }

 private:
  static constexpr double kWater_A = 3.0;
  static constexpr std::array<std::array<int, 3>, 6> kSteps{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  Vec3 at(int x, int y, int z) const { return low_A_ + Vec3(x, y, z) * cell_A_; }
  std::size_t index(int x, int y, int z) const {
    return (std::size_t(x) * std::size_t(side_) + std::size_t(y)) * std::size_t(side_) + std::size_t(z);
  }

  Vec3 low_A_;
  double cell_A_;
  int side_;
  std::vector<float> clear_A_, best_A_;  // to the nearest surface; along the widest way from open water, -1: none
};

}  // namespace moltact::test
