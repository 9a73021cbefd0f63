// The scenes in which haptic rendering of forces between atoms is known to fail, each with the motion of a hand that holds
// a probe of one atom. Deterministic functions of the seed. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/field/pair_model.h"

namespace moltact::bench {

struct FieldScene {
  std::string name;
  std::string question;                    ///< what the scene tests, one sentence
  std::vector<Sphere> spheres{};           ///< of the contact
  std::vector<PairAtom> atoms{};           ///< one per sphere
  PairAtom probe{};                        ///< at the origin
  double probe_A = 0.0;                    ///< of the contact
  std::shared_ptr<const HeldBody> body{};  ///< held instead of the probe; null: the probe
  std::vector<PairAtom> body_atoms{};      ///< one per sphere of the body
  PairModel model{};
  double loop_N_per_mm = 0.3;      ///< felt stiffness of the virtual coupling, as of the slider "Stiffness"
  double N_per_kcal_mol_A = 0.05;  ///< newtons in the hand for 1 kcal/mol/A
  std::vector<Vec3> path{};        ///< the target of the hand, one position per tick; it begins and ends far outside
  /// The ticks in which the hand stands still in the field: from, to. Equal: it does not.
  std::size_t held_from = 0, held_to = 0;

  /// What is held, relative to its middle.
  std::vector<PairAtom> held() const { return body ? body_atoms : std::vector<PairAtom>{probe}; }
};

/// All scenes, in the order of the tables. Draw 0 contains them as defined. In each further draw, scene and motion are
/// rotated as a whole by a random rotation and shifted by up to a cell of the grids.
std::vector<FieldScene> fieldScenes(std::uint64_t seed, std::size_t draw);

}  // namespace moltact::bench
