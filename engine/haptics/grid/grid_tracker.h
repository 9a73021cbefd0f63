// The god-object method on a signed-distance grid. The SCP lies on the level of the interpolated field
// (distance_bricks.h) that corresponds to the probe. It is the point nearest to the HIP that the SCP reaches by sliding
// downhill from its last position.
//
// In flight the SCP moves toward the HIP in steps no longer than the free distance given by the field. In contact the
// tracker solves for the foot of the HIP on the level by Newton steps in the tangent plane, with the second derivatives
// of the spline. Each step is shorter than the spacing, so the SCP slides along the surface and does not jump through a
// wall. Bricks are computed where the SCP arrives, at most kMaxFills per tick; if more are needed the SCP waits
// outside.
//
// Known limitations, verified by tests: a crease or pit is rounded over about one spacing, so the SCP floats above it
// and the force changes direction too gradually. A gap narrower than about one spacing closes or opens. A new brick
// makes a tick long. The feature is always Sphere, with the nearest sphere. Haptic thread; no allocation after
// construction. Units: angstrom.
#pragma once

#include <memory>

#include "engine/haptics/grid/distance_bricks.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class GridTracker final : public Tracker {
 public:
  /// `prepared`: computes and keeps every brick at the surface here, instead of when the SCP reaches it.
  GridTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, double spacing_A, bool prepared = false);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  double probe_A() const noexcept override { return probe_; }
  /// Counts the whole pool of bricks. Atoms modelled: those stored in the present bricks.
  MemoryUsage memoryUsage() const noexcept override;

  std::size_t wholeMoleculeBytes() const noexcept { return bricks_.wholeMoleculeBytes(); }
  std::uint64_t bricksMade() const noexcept { return bricks_.bricksMade(); }
  /// Number of ticks in which the SCP did not come to rest because steps or bricks ran out; it then lags, outside.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  static constexpr int kMaxFills = 8;   ///< bricks computed per tick
  static constexpr int kMaxSteps = 64;  ///< Newton steps per tick

 private:
  enum class SlideResult : std::uint8_t { Arrived, Meets, Leaves, Rests, Short };

  static double capFor(double probe_A, double spacing_A);
  // How far the field's surface may lie outside the spheres' surface.
  double margin() const { return 1.5 * bricks_.spacing_A(); }
  SlideResult fly(const Vec3& hip) noexcept;
  SlideResult slide(const Vec3& hip, bool pressed) noexcept;
  bool pushOut() noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  Vec3 origin_;
  DistanceBricks bricks_;
  double probe_;
  Vec3 scp_{0.0};                  // like every position inside the tracker, relative to origin_
  bool has_been_outside_ = false;  // the HIP has been outside since the start
  bool touching_ = false;
  Vec3 free_from_{0.0};  // free: the field's surface is at least free_gap_ from this point
  double free_gap_ = 0.0;
  Vec3 outward_{0.0};  // touching: the field's gradient at the SCP
  int fills_left_ = 0;
  int steps_left_ = 0;
  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
