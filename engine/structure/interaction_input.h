// The data of a molecule from which an interaction is created (interactions.h): spheres, what the hand holds, and, where
// the setup needs them, chemistry and the atoms of forces. Any thread except the haptic one. Units: angstrom, kcal/mol.
#pragma once

#include <memory>

#include "engine/haptics/interactions.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// `spheres` are the molecule's, one for each atom, at their present places; the untouchable ones exert no force. A body
/// is one of heldBody(). Null: the hand holds the probe.
InteractionInput interactionInput(const TouchSetup& touch, const Molecule& molecule,
                                  std::shared_ptr<const SphereGrid> spheres,
                                  std::shared_ptr<const HeldBody> body = nullptr);

/// The body of these atoms of the molecule, at the molecule's places; its radii are reduced as its table of radii requires.
/// Null as for heldBody().
std::shared_ptr<const HeldBody> heldBody(const Molecule& molecule, std::span<const std::uint32_t> atoms);

/// The probe's atom in forces between atoms: the oxygen of water (TIP3P: Jorgensen et al., J. Chem. Phys. 79, 926, 1983),
/// with this charge.
PairAtom probeAtom(double charge_e);

/// The atoms of the forces that the setup selects; null if it selects none. Parameters are those of pairAtoms(); with
/// the setup's charges "formal" the charges are those of formalCharges_e().
std::shared_ptr<const PairField> pairField(const TouchSetup& touch, const Molecule& molecule, const SphereGrid& spheres,
                                           const HeldBody* body);

}  // namespace moltact
