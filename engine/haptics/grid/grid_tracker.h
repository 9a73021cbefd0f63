// The god-object on a signed-distance grid. The SCP lies on the level of the interpolated field (distance_bricks.h)
// that the probe feels, at the place nearest to the HIP that it reaches by sliding downhill from its last place.
//
// In flight it moves toward the HIP by steps no longer than the free distance that the field gives. In contact it
// solves for the foot of the HIP on the level by Newton steps in the tangent plane (the Lagrangian's second derivatives
// are the spline's own). No step is longer than a part of the spacing, so the SCP slides along the surface and does not
// jump through a wall. Bricks are made where it comes, at most kMaxFills in a tick; where that is too few the SCP
// waits, outside.
//
// Known failures, pinned by tests: a crease or pit is rounded over about a spacing, so the SCP floats above it and the
// force changes direction there too gently; a gap narrower than about a spacing is closed or opened; a new brick makes
// a tick long. Feature: Sphere with the nearest sphere. Haptic thread; no allocation after construction. Units: angstrom.
#pragma once

#include <memory>

#include "engine/haptics/grid/distance_bricks.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class GridTracker final : public Tracker {
 public:
  /// `prepared`: every brick that the surface passes through is made here and kept, instead of where the SCP comes.
  GridTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, double spacing_A, bool prepared = false);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  double probe_A() const noexcept override { return probe_; }
  /// The pool of bricks is counted in full. Atoms modelled: those that the bricks held now remember.
  MemoryUsage memoryUsage() const noexcept override;

  std::size_t wholeMoleculeBytes() const noexcept { return bricks_.wholeMoleculeBytes(); }
  std::uint64_t bricksMade() const noexcept { return bricks_.bricksMade(); }
  /// Ticks in which the SCP did not come to rest for want of steps or bricks; it then lags, outside.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  static constexpr int kMaxFills = 8;   ///< bricks made in one tick
  static constexpr int kMaxSteps = 64;  ///< Newton steps in one tick

 private:
  enum class SlideResult : std::uint8_t { Arrived, Meets, Leaves, Rests, Short };

  static double capFor(double probe_A, double spacing_A);
  double margin() const {
    return 1.5 * bricks_.spacing_A();
  }  // how far the field's surface may lie outside the spheres'
  SlideResult fly(const Vec3& hip) noexcept;
  SlideResult slide(const Vec3& hip, bool pressed) noexcept;
  bool pushOut() noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  Vec3 origin_;
  DistanceBricks bricks_;
  double probe_;
  Vec3 scp_{0.0};                  // this and every place inside the tracker is relative to origin_
  bool has_been_outside_ = false;  // has the HIP been outside since the start?
  bool touching_ = false;
  Vec3 free_from_{0.0};  // free: the field's surface is not within free_gap_ of this place
  double free_gap_ = 0.0;
  Vec3 outward_{0.0};  // touching: the field's slope at the SCP
  int fills_left_ = 0;
  int steps_left_ = 0;
  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
