// The forces between atoms in a scene, for tasks and checks that judge by energy. They tell how firmly what the hand
// holds is bound, and where it falls when the hand yields. Any thread but the haptic one. Units: angstrom, kcal/mol.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/touch_setup.h"
#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// A pose at which what the hand holds stays, with its energy.
struct Well {
  PoseA pose;
  MolecularEnergy energy;
};

class SceneForces {
 public:
  /// `body` null: the hand holds the probe.
  SceneForces(const TouchSetup& touch, std::shared_ptr<const Molecule> molecule,
              std::shared_ptr<const SphereGrid> spheres, std::shared_ptr<const HeldBody> body);

  const TouchSetup& touch() const { return touch_; }
  const Molecule& molecule() const { return *molecule_; }
  const SphereGrid& spheres() const { return *spheres_; }
  const std::shared_ptr<const HeldBody>& body() const { return body_; }

  /// The same forces with another body in the hand, which the scene neither draws nor feels, like its own.
  std::shared_ptr<const SceneForces> holding(std::shared_ptr<const HeldBody> body) const;

  /// Where it comes to rest when a hand that offers no resistance begins at `start`, kept outside the atoms. `visit`
  /// gets each pose on the way with its energy; false ends it. Empty if it began inside, or no force acts there. `change`
  /// as a task's, over the scene's setup.
  std::optional<Well> fall(const PoseA& start, const TouchChange& change = {},
                           const std::function<bool(const Well&)>& visit = {}) const;

  /// The wells that `count` falls from the surface lead to, the deepest first. A body falls in random orientations,
  /// from the pose of its file first; a probe from the places with the lowest energy. The same arguments give the same
  /// wells. A search: a deeper well may exist. Falls begin only at places for which `from` is true.
  std::vector<Well> wells(int count, const TouchChange& change = {},
                          const std::function<bool(const Vec3&)>& from = {}) const;

 private:
  class Felt;
  std::vector<PoseA> starts(int count, Felt& felt, const std::function<bool(const Vec3&)>& from) const;

  TouchSetup touch_;
  std::shared_ptr<const Molecule> molecule_;
  std::shared_ptr<const SphereGrid> spheres_;
  std::shared_ptr<const HeldBody> body_;
};

/// The forces of a scene with the key `forces`; null where it has none. `molecule` is the scene's; `body` is what the hand
/// holds, or null.
std::shared_ptr<const SceneForces> sceneForces(const SceneSpec& scene, std::shared_ptr<const Molecule> molecule,
                                               std::span<const std::uint32_t> untouchable,
                                               std::shared_ptr<const HeldBody> body);

/// "-12.3 kcal/mol".
std::string energyText(double energy_kcal_mol);

}  // namespace moltact
