// A rigid body in the hand: six degrees of freedom, felt through its atoms.
//
// Each atom of the body is a probe of its own radius, led by the body's pose, with a tracker of the method in use: it
// has an SCP that stays outside every ball of the scene, so that no atom pops through what a penalty would let it
// through. A spring pulls each atom to its SCP; their sum is the force, and the sum of lever times displacement is the
// torque round the hand's place. (McNeely, Puterbaugh & Troy 1999 sum the forces of a body's points so; here the points
// are balls, and their contacts god-objects.) The springs do not know of each other: the body that is drawn is shifted
// by their mean, and neither it nor the SCPs are a rigid body's exact rest under constraints.
//
// `respond` runs on the haptic thread; its time is that of a tick of the method for each atom. Units: angstrom.
#pragma once

#include <memory>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/methods.h"

namespace moltact {

class RigidBody final : public Interaction {
 public:
  /// Neither is null.
  RigidBody(std::shared_ptr<const HeldBody> body, const Method& method, const std::shared_ptr<const BallScene>& scene);

  /// The contact's displacement and energy are the sums; its SCP is where the body's middle is shown, the hand's place
  /// shifted by the mean of the springs; atoms, feature and normals are of the atom of the body that is farthest from
  /// its SCP. A body of which an atom begins inside is not felt until none of it has been inside.
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  double parallelSprings() const noexcept override { return springs_; }
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  MemoryUsage memoryUsage() const noexcept override;
  bool hasOrientation() const noexcept override { return true; }

 private:
  std::shared_ptr<const HeldBody> body_;
  std::vector<std::unique_ptr<Tracker>> trackers_;  // one for each ball of the body
  double springs_ = 1.0;
};

}  // namespace moltact
