// Sweeps a point along a straight path to the first sphere: collision in free space (the paper's Algorithm 1, first
// branch), exact for steps of any length. Also finds the surface under a pointer. Safe on the haptic thread. Units:
// angstrom.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class SphereMotion;

/// The result of a sweep.
struct Hit {
  std::int32_t sphere = -1;  ///< index of the sphere; -1: none
  double t = 1.0;            ///< position on the path, from `from` (0) to `to` (1)
};

/// Finds the first sphere on a straight path among the spheres passed to look().
class FirstHit {
 public:
  /// `along` is a unit vector; spheres beyond `length` are ignored. A sphere within `contact_A` of the start counts as
  /// touched. It is hit only if the path penetrates it by contact_A, so that rounding does not stop a path along its
  /// surface.
  FirstHit(const Vec3& start, const Vec3& along, double length, double contact_A = 0.0)
      : start_(start), along_(along), best_(length), contact_(contact_A) {}

  void look(std::int32_t index, const Vec3& centre, double radius) {
    const Vec3 m = start_ - centre;
    const double nearest = -glm::dot(m, along_);  // path parameter of the closest approach
    if (nearest <= 0.0) return;                   // the path leads away from this sphere
    const Vec3 off = m + along_ * nearest;
    double chord2 = radius * radius - glm::dot(off, off);
    if (chord2 <= 0.0) return;
    double enters = nearest - std::sqrt(chord2);
    if (enters > best_) return;
    if (enters < radius) {  // the start may be inside or on the sphere; this near, the power is precise enough
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

  /// False only if no sphere inside the given one can be the first hit.
  bool mayMeet(const Vec3& centre, double radius) const {
    const Vec3 m = start_ - centre;
    const double nearest = -glm::dot(m, along_);
    const Vec3 off = m + along_ * nearest;
    const double chord2 = radius * radius - glm::dot(off, off);
    if (chord2 <= 0.0) return false;
    const double chord = std::sqrt(chord2);
    return nearest + chord > 0.0 && nearest - chord <= best_;
  }

  std::int32_t sphere() const { return sphere_; }  ///< the first hit; -1: none
  double at() const { return best_; }              ///< its distance from the start (unit: angstrom)

 private:
  Vec3 start_, along_;
  double best_, contact_;
  std::int32_t sphere_ = -1;
};

/// Reduces `gap` to the gap between a sphere and a point, if that is smaller. `from_centre` points from the centre to
/// the point.
inline void reduceGap(double& gap, const Vec3& from_centre, double radius) {
  const double d2 = glm::dot(from_centre, from_centre), reach = gap + radius;
  if (reach > 0.0 && d2 < reach * reach) gap = std::sqrt(d2) - radius;
}

/// Sweeps a point from `from` to `to` among the scene's spheres inflated by `probe_A`. A sphere that already contains
/// or touches the point is hit at t = 0 if the path leads into it, and ignored if the path leads out.
Hit sweep(const SphereGrid& scene, double probe_A, const Vec3& from, const Vec3& to) noexcept;

/// The same for positions relative to `origin`, which preserves precision far from the zero point, with the `contact_A`
/// of FirstHit. With a motion, `scene` is its sweptSpheres(), and the spheres are those at `fraction` of the motion.
Hit sweepFrom(const SphereGrid& scene, double probe_A, const Vec3& origin, const Vec3& from, const Vec3& to,
              double contact_A, const SphereMotion* motion = nullptr, double fraction = 0.0) noexcept;

/// The distance from `place` to the bounding box of all inflated spheres; 0 inside it.
double distanceToBox(const SphereGrid& scene, double probe_A, const Vec3& place) noexcept;

/// A lower bound of the distance from `place` to the nearest inflated sphere, exact below one grid cell; negative or
/// zero inside or on a sphere. Motion and fraction as in sweepFrom().
double clearance(const SphereGrid& scene, double probe_A, const Vec3& place, const SphereMotion* motion = nullptr,
                 double fraction = 0.0) noexcept;

}  // namespace moltact
