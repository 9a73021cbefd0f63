// The penalty method: the sum of each sphere's push, which a beginner writes first. A sphere that contains the HIP pushes
// it out along its radius by the depth; the pushes of all spheres are added. There is no proxy and no memory: the
// reported SCP is the HIP plus the sum, so that k (SCP - HIP) is the force, and it lies on the surface only where a
// single sphere pushes. The stored energy is the sum over the spheres of k depth^2 / 2, whose gradient is the force.
//
// Known failures, pinned by tests: where spheres overlap the pushes add up (a crease feels too stiff, and the SCP's path
// has a kink there but no jump; a device that cannot bear so stiff a surface gets softer springs,
// Response::springs); past a centre the push leads out on the far side, so that a HIP pressed deep enough or
// moved fast enough passes through; deep inside a molecule pushes from all sides cancel. A HIP on a centre gets no push
// from that sphere: no direction is better than another. Feature: Sphere, Circle or Point for one, two, three or more
// spheres that push; `atoms` are the three that push most. Haptic thread; no allocation after construction. Units:
// angstrom.
#pragma once

#include "engine/haptics/nearby_spheres.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class PenaltyTracker final : public Tracker {
 public:
  PenaltyTracker(std::shared_ptr<const SphereGrid> scene, double probe_A);

  Contact step(PointA hip) noexcept override;
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  double probe_A() const noexcept override { return nearby_.probe_A(); }
  MemoryUsage memoryUsage() const noexcept override;

 private:
  double stiffestDirection() const noexcept;

  NearbySpheres nearby_;
  Vec3 last_{0.0};                 // the last SCP, for the answer to a non-finite HIP
  bool has_been_outside_ = false;  // has the HIP been outside since the start?
  Vec3 free_from_{0.0};            // no sphere is within free_gap_ of this place
  double free_gap_ = 0.0;
  Vec3 squares_{0.0}, products_{0.0};  // sum of n n^T over the pushes of the last answer: its diagonal, and yz, zx, xy
};

}  // namespace moltact
