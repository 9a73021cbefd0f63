#include "engine/structure/accessible_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/even_directions.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {
namespace {

/// The cap of an inflated sphere inside another: directions with a component along `towards` above `beyond`.
struct Cap {
  Vec3 towards;
  double beyond;
};

class Area {
 public:
  Area(std::span<const Sphere> spheres, double probe_radius_A, int points)
      : probe_A_(std::max(probe_radius_A, 0.0)),
        grid_(grown(spheres, probe_A_), SphereGrid::Duplicates::VisitEach),
        points_(evenDirections(points)) {}

  double radius_A(std::uint32_t i) const { return grid_[i].radius_A; }
  /// Counts the sphere's free points, at most `limit`.
  int freePoints(std::uint32_t i, int limit) {
    if (!findCaps(i)) return 0;
    int free = 0;
    std::size_t last = 0;  // the cap that covered the last point most likely covers the next
    for (const Vec3& p : points_) {
      if (!caps_.empty() && buries(caps_[last], p)) continue;
      const auto by = std::find_if(caps_.begin(), caps_.end(), [&](const Cap& c) { return buries(c, p); });
      if (by != caps_.end())
        last = std::size_t(by - caps_.begin());
      else if (++free >= limit)
        break;
    }
    return free;
  }

 private:
  static std::vector<Sphere> grown(std::span<const Sphere> spheres, double probe_A) {
    std::vector<Sphere> out(spheres.begin(), spheres.end());
    for (Sphere& b : out) b.radius_A += probe_A;
    return out;
  }
  static bool buries(const Cap& c, const Vec3& p) { return glm::dot(c.towards, p) > c.beyond; }

  /// Finds the caps of the neighbours, the largest first; returns false if the whole sphere lies in another.
  bool findCaps(std::uint32_t i) {
    caps_.clear();
    const Sphere own = grid_[i];
    bool free = own.radius_A > 0.0;
    grid_.visitNear(own.centre_A, own.radius_A, [&](std::uint32_t j, const Sphere& other) {
      if (j == i) return;
      const Vec3 offset = other.centre_A - own.centre_A;
      const double apart = glm::length(offset);
      if (apart >= own.radius_A + other.radius_A || apart + other.radius_A <= own.radius_A) {
        // Separate, or within this one; of two equal spheres the first is kept.
        if (apart == 0.0 && other.radius_A == own.radius_A && j < i) free = false;
        return;
      }
      if (apart + own.radius_A <= other.radius_A) {
        free = false;
        return;
      }
      const double beyond = (own.radius_A * own.radius_A + apart * apart - other.radius_A * other.radius_A) /
                            (2.0 * own.radius_A * apart);
      caps_.push_back({offset / apart, beyond});
    });
    std::sort(caps_.begin(), caps_.end(), [](const Cap& a, const Cap& b) { return a.beyond < b.beyond; });
    return free;
  }

  double probe_A_;
  SphereGrid grid_;
  std::vector<Vec3> points_;
  std::vector<Cap> caps_;  // of the present sphere
};

}  // namespace

std::vector<double> accessibleAreas_A2(std::span<const Sphere> spheres, double probe_radius_A) {
  constexpr int kPoints = 2000;
  Area area(spheres, probe_radius_A, kPoints);
  std::vector<double> out(spheres.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const double r = area.radius_A(i);
    out[i] = 4.0 * std::numbers::pi * r * r * area.freePoints(i, kPoints) / kPoints;
  }
  return out;
}

std::vector<bool> accessibleSpheres(std::span<const Sphere> spheres, double probe_radius_A) {
  constexpr int kPoints = 500;
  Area area(spheres, probe_radius_A, kPoints);
  std::vector<bool> out(spheres.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = area.freePoints(i, 1) > 0;
  return out;
}

}  // namespace moltact
