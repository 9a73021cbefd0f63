// The penalty method: the sum of all spheres' pushes. A sphere that contains the HIP pushes it outward along the
// radius, in proportion to the depth. There is no proxy and no state. The reported SCP is the HIP plus the sum of the
// depth vectors, so that k (SCP - HIP) is the force. It lies on the surface only where a single sphere pushes. The
// stored energy is the sum of k depth^2 / 2 over the spheres; the force is its negative gradient.
//
// Known limitations, verified by tests. Where spheres overlap the pushes add: a crease is too stiff, and the SCP's path
// has a kink but no jump. A device that cannot render such a stiffness gets softer springs (Response::stiffness_factor). Beyond
// a centre the push points to the far side, so a HIP pressed deep enough or moved fast enough passes through. Deep
// inside a molecule the pushes of all sides cancel. A HIP exactly on a centre gets no push from that sphere, because no
// direction is preferred.
//
// The feature is Sphere, Circle or Point for one, two, or three and more pushing spheres; `atoms` are the three that
// push most. Haptic thread; no allocation after construction. Units: angstrom.
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
  Vec3 last_{0.0};                 // the last SCP, returned for a non-finite HIP
  bool has_been_outside_ = false;  // the HIP has been outside since the start
  Vec3 free_from_{0.0};            // every sphere is at least free_gap_ from this point
  double free_gap_ = 0.0;
  Vec3 squares_{0.0}, products_{0.0};  // sum of n n^T over the last pushes: the diagonal; yz, zx, xy
};

}  // namespace moltact
