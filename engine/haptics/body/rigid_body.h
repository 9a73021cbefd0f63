// A rigid body in the hand: six degrees of freedom, felt through its atoms.
//
// Each atom of the body is a sphere of its own radius, led by the body's pose and felt as a probe is (makeSphere in
// interactions.cpp): it has an SCP that stays outside every sphere of the scene, so that no atom pops through what a penalty
// would let it through. A spring pulls each atom to its SCP; their sum is the force, and the sum of lever times displacement is the
// torque round the hand's place. (McNeely, Puterbaugh & Troy 1999 sum the forces of a body's points so; here the points
// are spheres, and their contacts god-objects.) The springs do not know of each other: the body that is drawn is shifted
// by their mean, and neither it nor the SCPs are a rigid body's exact rest under constraints.
//
// `respond` runs on the haptic thread; its time, also at worst, is that of a tick of the method for each atom. Units:
// angstrom.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/interaction.h"

namespace moltact {

class RigidBody final : public Interaction {
 public:
  /// What feels the scene with a sphere of this radius; never null.
  using MakeSphere = std::function<std::unique_ptr<Interaction>(double radius_A)>;
  /// The body is never null. `shared_bytes`: of memory that all spheres count as theirs and is there once, as the scene's.
  RigidBody(std::shared_ptr<const HeldBody> body, const MakeSphere& make, std::size_t shared_bytes = 0);

  /// The contact's displacement and energy are the sums; its SCP is where the body's middle is shown, the hand's place
  /// shifted by the mean of the springs; atoms, feature and normals are of the atom of the body that is farthest from
  /// its SCP. A body of which an atom begins inside is not felt until none of it has been inside.
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                        std::span<AtomForce> out) const noexcept override;
  std::size_t greatestReactionCount() const noexcept override { return greatest_reaction_count_; }
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  MemoryUsage memoryUsage() const noexcept override;
  bool hasOrientation() const noexcept override { return true; }

 private:
  std::shared_ptr<const HeldBody> body_;
  std::vector<std::unique_ptr<Interaction>> spheres_;  // one for each sphere of the body
  std::size_t shared_bytes_;
  // The spheres that were felt at the last pose, with their answers: the first held_ of as many as there are spheres.
  struct Held {
    Response answer;
    std::size_t sphere = 0;
  };
  std::vector<Held> answers_;
  std::size_t held_ = 0;
  std::size_t greatest_reaction_count_ = 0;
};

}  // namespace moltact
