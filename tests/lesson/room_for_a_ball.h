// The reachable places for the centre of a sphere in a rigid molecule, on a grid: the oracle for holes and gaps in
// lessons, without trackers and surface places. Grid points are never inside an atom's grown sphere, so every path
// found is real. A hole that is wider than the sphere by less than half a cell may be missed. Unit: angstrom.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "engine/haptics/sphere_grid.h"

namespace moltact::test {

class RoomForASphere {
 public:
  RoomForASphere(const SphereGrid& spheres, double sphere_A, Vec3 low_A, Vec3 high_A, double cell_A)
      : low_A_(low_A), cell_A_(cell_A) {
    for (int k = 0; k < 3; ++k) count_[k] = 1 + static_cast<int>(std::floor((high_A[k] - low_A[k]) / cell_A));
    cells_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]), Free);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const Sphere& b = spheres[i];
      const double grown = b.radius_A + sphere_A;
      int from[3], to[3];
      for (int k = 0; k < 3; ++k) {
        from[k] = std::max(0, static_cast<int>(std::ceil((b.centre_A[k] - grown - low_A[k]) / cell_A)));
        to[k] = std::min(count_[k] - 1, static_cast<int>(std::floor((b.centre_A[k] + grown - low_A[k]) / cell_A)));
      }
      for (int x = from[0]; x <= to[0]; ++x)
        for (int y = from[1]; y <= to[1]; ++y)
          for (int z = from[2]; z <= to[2]; ++z)
            if (glm::distance(at(x, y, z), b.centre_A) < grown) cells_[index(x, y, z)] = Shut;
    }
  }

  /// Fills from the upper face of the box (maximum z) downward, where `within` returns true.
  void fillFromAbove(const std::function<bool(const Vec3&)>& within) {
    std::vector<std::array<int, 3>> open;
    const auto fill = [&](int x, int y, int z) {
      if (x < 0 || y < 0 || z < 0 || x >= count_[0] || y >= count_[1] || z >= count_[2]) return;
      if (cells_[index(x, y, z)] != Free || !within(at(x, y, z))) return;
      cells_[index(x, y, z)] = Filled;
      open.push_back({x, y, z});
    };
    for (int x = 0; x < count_[0]; ++x)
      for (int y = 0; y < count_[1]; ++y) fill(x, y, count_[2] - 1);
    while (!open.empty()) {
      const auto [x, y, z] = open.back();
      open.pop_back();
      for (const int step : {-1, 1}) {
        fill(x + step, y, z);
        fill(x, y + step, z);
        fill(x, y, z + step);
      }
    }
  }

  /// The lowest place that was filled, if any.
  std::optional<Vec3> lowest() const {
    for (int z = 0; z < count_[2]; ++z)
      for (int x = 0; x < count_[0]; ++x)
        for (int y = 0; y < count_[1]; ++y)
          if (cells_[index(x, y, z)] == Filled) return at(x, y, z);
    return std::nullopt;
  }

  /// Whether the lower face of the box was reached.
  bool through() const {
    const auto place = lowest();
    return place && place->z < low_A_.z + 0.5 * cell_A_;
  }

 private:
  enum Cell : char { Free, Shut, Filled };
  Vec3 at(int x, int y, int z) const { return low_A_ + Vec3(x, y, z) * cell_A_; }
  std::size_t index(int x, int y, int z) const {
    return (std::size_t(x) * std::size_t(count_[1]) + std::size_t(y)) * std::size_t(count_[2]) + std::size_t(z);
  }

  Vec3 low_A_;
  double cell_A_;
  int count_[3];
  std::vector<Cell> cells_;
};

}  // namespace moltact::test
