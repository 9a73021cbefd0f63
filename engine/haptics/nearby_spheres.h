// The inflated spheres near a point. The list is reused while the point moves little, so that a method which examines
// every neighbour in every tick need not search the grid. Haptic thread; no allocation after construction. Units:
// angstrom. Positions are relative to origin(), which preserves precision in a scene far from the zero point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/sweep.h"

namespace moltact {

/// A sphere near the tracker, at its present position.
struct NearSphere {
  Vec3 centre;
  double radius;       ///< inflated by the probe
  std::int32_t index;  ///< in the scene
};

class NearbySpheres {
 public:
  static constexpr std::size_t kMax = 256;  ///< capacity of the list

  /// The policy when more than kMax spheres are near: VisitScene searches the grid at every call, so that all are
  /// found; ReachLess shortens the range of the list, which bounds the cost of a visit.
  enum class Crowded : std::uint8_t { VisitScene, ReachLess };

  /// A list is valid until the point has moved by `margin_A`.
  explicit NearbySpheres(std::shared_ptr<const SphereGrid> scene, double margin_A = 0.5,
                         Crowded crowded = Crowded::VisitScene)
      : scene_(std::move(scene)),
        margin_(margin_A),
        crowded_(crowded),
        origin_(1024.0 * glm::round((scene_->low_A() + scene_->high_A()) / 2048.0)) {}

  /// The grid that is searched: the scene, or during a motion the bounds of its spheres. sphere() gives the actual
  /// spheres.
  const SphereGrid& scene() const noexcept { return motion_ ? motion_->sweptSpheres() : *scene_; }
  /// The scene's middle rounded to multiples of 1024 A, so that a difference to it loses no digit where both are
  /// of like size; zero for a scene near the zero point.
  const Vec3& origin() const noexcept { return origin_; }
  double probe_A() const noexcept { return probe_; }
  std::size_t held() const noexcept { return count_; }  ///< spheres in the list
  /// Number of spheres, cells and groups examined since the last reset: the cost of a tick.
  std::uint64_t workCount() const noexcept { return work_count_; }
  void resetWorkCount() noexcept { work_count_ = 0; }
  /// Inflates the spheres by another radius. The list stays valid, but its range shrinks by the growth.
  void setProbe(double probe_A) noexcept {
    const double grown = probe_A - probe_;
    probe_ = probe_A;
    reach_ -= grown + kSpare_A;
    if (!fits_ || !(reach_ > 0.0)) {
      reach_ = -1.0;
      count_ = 0;
      return;
    }
    work_count_ += count_;
    for (std::size_t k = 0; k < count_; ++k) list_[k].radius = sphere(list_[k].index).radius;
  }

  /// Switches to the spheres of a motion, at its beginning; null: the scene's own spheres. The motion has the same
  /// number of spheres and must live until another is set.
  void setMotion(const SphereMotion* motion) noexcept {
    // A motion that continues the last one brings distant spheres nearer by at most its largest displacement.
    const bool continued = motion && motion_ && fraction_ == 1.0 && motion->continues(*motion_) && fits_ && !shrunk_;
    motion_ = motion;
    motion_serial_ = motion ? motion->serial() : 0;
    fraction_ = 0.0;
    reach_ = continued ? reach_ - motion->maxMotion_A() : -1.0;
    if (reach_ < 0.0) count_ = 0;
    stale_ = count_ > 0;
    max_motion_ = maxMotionOfList_A();
  }
  /// True if this motion is in use (null: none). Motions are compared by serial number, because an address may be
  /// reused.
  bool has(const SphereMotion* motion) const noexcept { return (motion ? motion->serial() : 0) == motion_serial_; }
  double fraction() const noexcept { return fraction_; }
  /// Moves the spheres to this fraction (0 to 1) of the motion. The list stays valid: it contains all spheres that come
  /// near during the motion.
  void advanceTo(double fraction) noexcept {
    fraction_ = fraction;
    stale_ = motion_ != nullptr;
  }
  /// Upper bound of the motion of a listed sphere's surface during the whole motion; infinite without a list.
  double maxMotion_A() const noexcept {
    if (!motion_) return 0.0;
    return reach_ < 0.0 || !fits_ ? std::numeric_limits<double>::infinity() : max_motion_;
  }
  /// True if the list contains every sphere within `within_A` of the point.
  bool covers(const Vec3& place, double within_A) const noexcept {
    return fits_ && glm::distance(place, around_) + within_A <= reach_;
  }

  NearSphere sphere(std::int32_t i) const noexcept {
    return inflated(i, motion_ ? (*motion_)[std::size_t(i)].at(fraction_) : (*scene_)[std::size_t(i)]);
  }

  /// Calls visit(NearSphere) once for each sphere within `within_A` of the point and for some farther ones. Returns the
  /// distance within which all spheres have been visited: at least within_A, except with Crowded::ReachLess. The order
  /// depends only on the sequence of queried points.
  template <class Visit>
  double each(const Vec3& place, double within_A, Visit&& visit) noexcept {
    if (!(glm::distance(place, around_) + within_A <= reach_)) [[unlikely]]
      look(place, within_A);
    if (stale_) [[unlikely]]
      refresh();
    if (fits_) {
      work_count_ += count_;
      for (std::size_t k = 0; k < count_; ++k) visit(list_[k]);
      return reach_ - glm::distance(place, around_);
    }
    scene().visitNear(origin_ + place, probe_ + within_A, [&](std::uint32_t i, const Sphere& b) {
      ++work_count_;
      visit(now(i, b));
    });
    return within_A;
  }

  /// True if a listed sphere contains the point, without a search of the grid. False does not mean outside.
  bool knownInside(const Vec3& place) noexcept {
    if (stale_) [[unlikely]]
      refresh();
    for (std::size_t k = 0; k < count_; ++k) {
      const Vec3 m = place - list_[k].centre;
      if (glm::dot(m, m) < list_[k].radius * list_[k].radius) return true;
    }
    return false;
  }

  /// True if a sphere of the scene contains the point.
  bool inside(const Vec3& place) const noexcept {
    bool found = false;
    scene().visitNear(origin_ + place, probe_, [&](std::uint32_t i, const Sphere& b) {
      const NearSphere sphere = now(i, b);
      const Vec3 m = place - sphere.centre;
      found = glm::dot(m, m) < sphere.radius * sphere.radius;
      return !found;
    });
    return found;
  }

  /// A lower bound of the distance from the point to the nearest sphere; negative or zero inside or on a sphere.
  double clearanceAt(const Vec3& place) const noexcept {
    return clearance(scene(), probe_, origin_ + place, motion_, fraction_);
  }
  /// The first sphere on the straight path between two points; `contact_A` as in FirstHit.
  Hit firstHit(const Vec3& from, const Vec3& to, double contact_A) const noexcept {
    return sweepFrom(scene(), probe_, origin_, from, to, contact_A, motion_, fraction_);
  }

 private:
  static constexpr double kMinReach_A = 1e-7;
  static constexpr double kSpare_A = 1e-12;  // exceeds the rounding of a range after a change of the probe

  // Recomputes the listed spheres at the present fraction.
  void refresh() noexcept {
    for (std::size_t k = 0; k < count_; ++k) list_[k] = sphere(list_[k].index);
    stale_ = false;
  }

  double maxMotionOfList_A() const noexcept {
    double max_A = 0.0;
    for (std::size_t k = 0; motion_ && k < count_; ++k)
      max_A = std::max(max_A, (*motion_)[std::size_t(list_[k].index)].moved_A());
    return max_A;
  }

  // The present state of sphere i; `b` is its entry in scene().
  NearSphere now(std::uint32_t i, const Sphere& b) const noexcept {
    return inflated(std::int32_t(i), motion_ ? (*motion_)[i].at(fraction_) : b);
  }

  NearSphere inflated(std::int32_t i, const Sphere& b) const noexcept {
    return {b.centre_A - origin_, b.radius_A + probe_, i};
  }

  void look(const Vec3& place, double within_A) noexcept {
    const double wanted = within_A + margin_;
    if (crowded_ == Crowded::VisitScene) {
      fits_ = gather(place, wanted);
      return;
    }
    // A list with a shortened range is kept while the point is well within it.
    const bool shrunk = shrunk_ && reach_ > 0.0;
    if (shrunk && glm::distance(place, around_) <= 0.5 * reach_) return;
    double reach = shrunk ? std::min(wanted, 4.0 * reach_) : wanted;
    while (!gather(place, reach)) {
      if (reach < kMinReach_A) {  // too many spheres at one point: nothing around it is known
        reach_ = 0.0;
        break;
      }
      reach *= 0.25;
    }
    shrunk_ = reach < wanted;
    fits_ = true;
  }

  // Lists the spheres within `reach` of the point; false if they exceed the capacity.
  bool gather(const Vec3& place, double reach) noexcept {
    around_ = place;
    reach_ = reach;
    count_ = 0;
    stale_ = false;
    bool fits = true;
    scene().visitNear(
        origin_ + place, probe_ + reach_,
        [&](std::uint32_t i, const Sphere& b) {
          ++work_count_;
          const Vec3 m = place - (b.centre_A - origin_);
          const double far = b.radius_A + probe_ + reach_;
          if (glm::dot(m, m) > far * far) return true;
          fits = count_ < kMax;
          if (fits) list_[count_++] = now(i, b);
          return fits;
        },
        &work_count_);
    max_motion_ = maxMotionOfList_A();
    return fits;
  }

  std::shared_ptr<const SphereGrid> scene_;
  const SphereMotion* motion_ = nullptr;
  std::uint64_t motion_serial_ = 0;
  double fraction_ = 0.0, max_motion_ = 0.0;
  bool stale_ = false;  // the listed spheres have moved since refresh()
  double margin_;
  Crowded crowded_;
  Vec3 origin_;
  double probe_ = 0.0;
  Vec3 around_{0.0};
  double reach_ = -1.0;
  bool fits_ = false, shrunk_ = false;
  std::uint64_t work_count_ = 0;
  std::size_t count_ = 0;
  std::array<NearSphere, kMax> list_;
};

}  // namespace moltact
