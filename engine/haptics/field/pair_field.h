// The atoms between which the layer "forces" (interactions.h) computes energies: those of the scene and of what the hand
// holds, with their parameters. Built by engine/structure/interaction_input.h, immutable afterwards. Units: angstrom,
// kcal/mol, elementary charge.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/haptics/field/pair_model.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

struct PairField {
  /// The centres of the scene's atoms that act on the hand and of their placed hydrogens. The radii are not used.
  std::shared_ptr<const SphereGrid> places;
  std::vector<PairAtom> atoms;          ///< one per place
  std::vector<std::uint32_t> carriers;  ///< of each, the sphere of the scene that feels its force
  /// What the hand holds, relative to its middle: the body's atoms and placed hydrogens, or one atom at the probe's
  /// centre.
  std::vector<PairAtom> held;
  /// Of each held atom, the atom of HeldBody (index in its lists) that carries it; empty for a probe.
  std::vector<std::uint32_t> held_carriers;
  PairModel model;
  std::string faults;  ///< what is wrong with these parameters (engine/structure/amber/charge_faults.h); empty: nothing
};

}  // namespace moltact
