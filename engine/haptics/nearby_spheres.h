// The spheres near a place, inflated, kept while the place moves little: what a method that looks at every
// neighbour in every tick need not look up anew. Haptic thread; no allocation after construction. Units:
// angstrom. Places are relative to origin(): near a scene that lies far off no digits are lost.
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

struct NearSphere {
  Vec3 centre;
  double radius;  ///< inflated by the probe
  std::int32_t index;
};

class NearbySpheres {
 public:
  static constexpr std::size_t kMax = 256;  ///< the longest list that is kept

  /// What becomes of a list that would be longer: the scene is visited each time, so that all is seen; or the list
  /// reaches less far, so that no visit costs much.
  enum class Crowded : std::uint8_t { VisitScene, ReachLess };

  /// A list serves until the place has moved by `margin_A`.
  explicit NearbySpheres(std::shared_ptr<const SphereGrid> scene, double margin_A = 0.5,
                         Crowded crowded = Crowded::VisitScene)
      : scene_(std::move(scene)),
        margin_(margin_A),
        crowded_(crowded),
        origin_(1024.0 * glm::round((scene_->low_A() + scene_->high_A()) / 2048.0)) {}

  /// What is visited: the scene, or the bounds of a motion's spheres, whose radii and places are sphere()'s.
  const SphereGrid& scene() const noexcept { return motion_ ? motion_->sweptSpheres() : *scene_; }
  /// The scene's middle in whole steps of 1024 A, so that differences to it are exact; zero for a scene near
  /// the origin.
  const Vec3& origin() const noexcept { return origin_; }
  double probe_A() const noexcept { return probe_; }
  std::size_t held() const noexcept { return count_; }  ///< spheres in the list
  /// Spheres, and cells and groups of spheres, looked at since the counter was set back: what a tick has cost.
  std::uint64_t looked() const noexcept { return looked_; }
  void resetWorkCount() noexcept { looked_ = 0; }
  /// The list stays in use: where the spheres have grown by a little, the list is sure of as much less distance round it.
  void setProbe(double probe_A) noexcept {
    const double grown = probe_A - probe_;
    probe_ = probe_A;
    reach_ -= grown + kSpare_A;
    if (!fits_ || !(reach_ > 0.0)) {
      reach_ = -1.0;
      count_ = 0;
      return;
    }
    looked_ += count_;
    for (std::size_t k = 0; k < count_; ++k) list_[k].radius = sphere(list_[k].index).radius;
  }

  /// From now on the spheres are those of the motion, at its beginning; null: the scene's own. The motion has as many
  /// as the scene, and stays until another is set.
  void setMotion(const SphereMotion* motion) noexcept {
    // Where it goes on from the last one's end, what was far off has come nearer by no more than it moves.
    const bool goes_on = motion && motion_ && fraction_ == 1.0 && motion->continues(*motion_) && fits_ && !shrunk_;
    motion_ = motion;
    motion_serial_ = motion ? motion->serial() : 0;
    fraction_ = 0.0;
    reach_ = goes_on ? reach_ - motion->mostMoved_A() : -1.0;
    if (reach_ < 0.0) count_ = 0;
    stale_ = count_ > 0;
    most_moved_ = mostMovedOfList_A();
  }
  /// Whether that motion is in force; null: none. One that lies where another lay is another.
  bool has(const SphereMotion* motion) const noexcept { return (motion ? motion->serial() : 0) == motion_serial_; }
  double fraction() const noexcept { return fraction_; }
  /// The spheres as they are at this fraction of the motion (0 to 1). The list stays: it holds all that come near
  /// during the motion.
  void advanceTo(double fraction) noexcept {
    fraction_ = fraction;
    stale_ = motion_ != nullptr;
  }
  /// No listed sphere's surface moves farther than this in the whole motion; infinite where there is no list.
  double mostMoved_A() const noexcept {
    if (!motion_) return 0.0;
    return reach_ < 0.0 || !fits_ ? std::numeric_limits<double>::infinity() : most_moved_;
  }
  /// The list holds all that come within `within_A` of the place.
  bool covers(const Vec3& place, double within_A) const noexcept {
    return fits_ && glm::distance(place, around_) + within_A <= reach_;
  }

  NearSphere sphere(std::int32_t i) const noexcept {
    return inflated(i, motion_ ? (*motion_)[std::size_t(i)].at(fraction_) : (*scene_)[std::size_t(i)]);
  }

  /// Calls visit(NearSphere) once for each sphere that comes within `within_A` of the place, and for some farther
  /// ones; returns how near to the place all spheres have been visited: at least within_A, but for Crowded::ReachLess.
  /// The order follows from the places asked for.
  template <class Visit>
  double each(const Vec3& place, double within_A, Visit&& visit) noexcept {
    if (!(glm::distance(place, around_) + within_A <= reach_)) [[unlikely]]
      look(place, within_A);
    if (stale_) [[unlikely]]
      refresh();
    if (fits_) {
      looked_ += count_;
      for (std::size_t k = 0; k < count_; ++k) visit(list_[k]);
      return reach_ - glm::distance(place, around_);
    }
    scene().visitNear(origin_ + place, probe_ + within_A, [&](std::uint32_t i, const Sphere& b) {
      ++looked_;
      visit(now(i, b));
    });
    return within_A;
  }

  /// True where a sphere of the list holds the place: without looking round. False tells nothing.
  bool knownInside(const Vec3& place) noexcept {
    if (stale_) [[unlikely]]
      refresh();
    for (std::size_t k = 0; k < count_; ++k) {
      const Vec3 m = place - list_[k].centre;
      if (glm::dot(m, m) < list_[k].radius * list_[k].radius) return true;
    }
    return false;
  }

  /// True where a sphere of the scene holds the place.
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

  /// A lower bound of the distance from the place to the nearest sphere; negative or zero inside or on one.
  double clearanceAt(const Vec3& place) const noexcept {
    return clearance(scene(), probe_, origin_ + place, motion_, fraction_);
  }
  /// The first sphere on the straight path from one place to another; `contact_A` as FirstMet has it.
  Hit firstMet(const Vec3& from, const Vec3& to, double contact_A) const noexcept {
    return sweepFrom(scene(), probe_, origin_, from, to, contact_A, motion_, fraction_);
  }

 private:
  static constexpr double kMinReach_A = 1e-7;
  static constexpr double kSpare_A =
      1e-12;  // a reach that has been reckoned on by a change of the probe is off by less

  // The list's spheres as they are at this fraction.
  void refresh() noexcept {
    for (std::size_t k = 0; k < count_; ++k) list_[k] = sphere(list_[k].index);
    stale_ = false;
  }

  double mostMovedOfList_A() const noexcept {
    double most = 0.0;
    for (std::size_t k = 0; motion_ && k < count_; ++k)
      most = std::max(most, (*motion_)[std::size_t(list_[k].index)].moved_A());
    return most;
  }

  // A sphere as it is now, of which the scene or the motion's bounds hold `b`.
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
    // A list that had to reach less serves while the place is within it.
    const bool shrunk = shrunk_ && reach_ > 0.0;
    if (shrunk && glm::distance(place, around_) <= 0.5 * reach_) return;
    double reach = shrunk ? std::min(wanted, 4.0 * reach_) : wanted;
    while (!gather(place, reach)) {
      if (reach < kMinReach_A) {  // so many in one place cannot be told apart: nothing round it is known
        reach_ = 0.0;
        break;
      }
      reach *= 0.25;
    }
    shrunk_ = reach < wanted;
    fits_ = true;
  }

  // Lists the spheres within `reach` of the place; false where there are more than fit.
  bool gather(const Vec3& place, double reach) noexcept {
    around_ = place;
    reach_ = reach;
    count_ = 0;
    stale_ = false;
    bool fits = true;
    scene().visitNear(
        origin_ + place, probe_ + reach_,
        [&](std::uint32_t i, const Sphere& b) {
          ++looked_;
          const Vec3 m = place - (b.centre_A - origin_);
          const double far = b.radius_A + probe_ + reach_;
          if (glm::dot(m, m) > far * far) return true;
          fits = count_ < kMax;
          if (fits) list_[count_++] = now(i, b);
          return fits;
        },
        &looked_);
    most_moved_ = mostMovedOfList_A();
    return fits;
  }

  std::shared_ptr<const SphereGrid> scene_;
  const SphereMotion* motion_ = nullptr;
  std::uint64_t motion_serial_ = 0;
  double fraction_ = 0.0, most_moved_ = 0.0;
  bool stale_ = false;  // the list's spheres have moved on
  double margin_;
  Crowded crowded_;
  Vec3 origin_;
  double probe_ = 0.0;
  Vec3 around_{0.0};
  double reach_ = -1.0;
  bool fits_ = false, shrunk_ = false;
  std::uint64_t looked_ = 0;
  std::size_t count_ = 0;
  std::array<NearSphere, kMax> list_;
};

}  // namespace moltact
