// A rigid body in the hand: six degrees of freedom, felt through its atoms.
//
// Each atom of the body is a sphere of its own radius that follows the body's pose. It is rendered like a probe: its
// SCP stays outside every sphere of the scene, so no atom passes through a thin wall as with a penalty method. A
// spring pulls each atom to its SCP. The force is the sum of the springs; the torque about the hand's position is
// the sum of lever cross displacement. (McNeely, Puterbaugh & Troy 1999 sum the forces of a body's points in the
// same way; here the points are spheres with god-object contacts.)
//
// The springs are independent. The drawn body is shifted by their mean, so neither it nor the SCPs are the exact rest
// position of a rigid body under constraints.
//
// `respond` runs on the haptic thread; its time, also in the worst case, is that of one tick of the method per atom.
// Units: angstrom.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/interaction.h"

namespace moltact {

class RigidBody final : public Interaction {
 public:
  /// Creates the interaction of a sphere with this radius; never returns null.
  using MakeSphere = std::function<std::unique_ptr<Interaction>(double radius_A)>;
  /// `body` must not be null. `shared_bytes`: memory that every sphere counts as its own but that exists once, such as
  /// the scene (unit: byte).
  RigidBody(std::shared_ptr<const HeldBody> body, const MakeSphere& make, std::size_t shared_bytes = 0);

  /// The contact's displacement and energy are the sums. Its SCP is the position at which the body's middle is drawn:
  /// the hand's position shifted by the mean of the springs. Atoms, feature and normals are those of the atom of the
  /// body that is farthest from its SCP. If an atom starts inside, there is no force until the whole body has been
  /// outside.
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                        std::span<AtomForce> out) const noexcept override;
  std::size_t maxReactionCount() const noexcept override { return max_reaction_count_; }
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  MemoryUsage memoryUsage() const noexcept override;
  bool hasOrientation() const noexcept override { return true; }

 private:
  std::shared_ptr<const HeldBody> body_;
  std::vector<std::unique_ptr<Interaction>> spheres_;  // one per sphere of the body
  std::size_t shared_bytes_;
  // The spheres with a force at the last pose and their responses: the first held_ entries; allocated for all spheres.
  struct Held {
    Response answer;
    std::size_t sphere = 0;
  };
  std::vector<Held> answers_;
  std::size_t held_ = 0;
  std::size_t max_reaction_count_ = 0;
};

}  // namespace moltact
