// The first sphere that a moving point meets: collision in free space (the paper's Algorithm 1, first branch), exact for
// steps of any length. Also used to find the surface under a pointer. Units: angstrom. Safe on the haptic thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class SphereMotion;

struct Hit {
  std::int32_t sphere = -1;  ///< -1: nothing is met
  double t = 1.0;            ///< where on the path from `from` (0) to `to` (1)
};

/// Finds the first sphere on a straight path, among the spheres passed to look() one after the other.
class FirstMet {
 public:
  /// `along` is unit; spheres farther than `length` are not met. A sphere within `contact_A` of the start is touched: it is
  /// met only where the path sinks by contact_A into it, so that a path along its surface is not stopped by rounding.
  FirstMet(const Vec3& start, const Vec3& along, double length, double contact_A = 0.0)
      : start_(start), along_(along), best_(length), contact_(contact_A) {}

  void look(std::int32_t index, const Vec3& centre, double radius) {
    const Vec3 m = start_ - centre;
    const double nearest = -glm::dot(m, along_);  // where the path comes nearest to the centre
    if (nearest <= 0.0) return;                   // it leads away from this sphere
    const Vec3 off = m + along_ * nearest;
    double chord2 = radius * radius - glm::dot(off, off);
    if (chord2 <= 0.0) return;
    double enters = nearest - std::sqrt(chord2);
    if (enters > best_) return;
    if (enters < radius) {  // the start may be in or on it: |start - centre|^2 - radius^2, exact enough this near
      const double power = glm::dot(m, m) - radius * radius, touches = 2.0 * radius * contact_;
      if (power <= touches) {
        chord2 = nearest * nearest - touches - std::max(power, 0.0);
        if (chord2 < 0.0) return;
        enters = nearest - std::sqrt(chord2);
      }
    }
    enters = std::max(0.0, enters);
    if (enters > best_ || (enters == best_ && sphere_ >= 0)) return;
    best_ = enters;
    sphere_ = index;
  }

  /// False only where no sphere within this one can be met first.
  bool mayMeet(const Vec3& centre, double radius) const {
    const Vec3 m = start_ - centre;
    const double nearest = -glm::dot(m, along_);
    const Vec3 off = m + along_ * nearest;
    const double chord2 = radius * radius - glm::dot(off, off);
    if (chord2 <= 0.0) return false;
    const double chord = std::sqrt(chord2);
    return nearest + chord > 0.0 && nearest - chord <= best_;
  }

  std::int32_t sphere() const { return sphere_; }  ///< -1: none
  double at() const { return best_; }              ///< the distance to it (unit: angstrom)

 private:
  Vec3 start_, along_;
  double best_, contact_;
  std::int32_t sphere_ = -1;
};

/// Lessens `gap` to the gap between a sphere and a place, given from its centre, where that is smaller.
inline void lessenGap(double& gap, const Vec3& from_centre, double radius) {
  const double d2 = glm::dot(from_centre, from_centre), reach = gap + radius;
  if (reach > 0.0 && d2 < reach * reach) gap = std::sqrt(d2) - radius;
}

/// Moves a point from `from` to `to` among the scene's spheres inflated by `probe_A`. A sphere that the point is in or on
/// already is met at t = 0 when the path leads into it and not at all when it leads out.
Hit sweep(const SphereGrid& scene, double probe_A, const Vec3& from, const Vec3& to) noexcept;

/// The same for places given from `origin`, so that far from the zero point no digits are lost, with FirstMet's
/// `contact_A`.
/// With a motion the scene is its bounds, and the spheres are where they are at that fraction of it.
Hit sweepFrom(const SphereGrid& scene, double probe_A, const Vec3& origin, const Vec3& from, const Vec3& to,
              double contact_A, const SphereMotion* motion = nullptr, double fraction = 0.0) noexcept;

/// The distance from `place` to the box round all inflated spheres, 0 inside it.
double distanceToBox(const SphereGrid& scene, double probe_A, const Vec3& place) noexcept;

/// A lower bound of the distance from `place` to the nearest inflated sphere, exact when under one grid cell;
/// negative or zero inside or on a sphere. Motion and fraction as of sweepFrom().
double clearance(const SphereGrid& scene, double probe_A, const Vec3& place, const SphereMotion* motion = nullptr,
                 double fraction = 0.0) noexcept;

}  // namespace moltact
