// Hydrogen bonds between the heavy atoms of a molecule, for drawing and counting. Computed on request, not in a tick;
// pure functions, any thread except the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/structure/bonds.h"

namespace moltact {

struct HydrogenBond {
  std::uint32_t donor = 0, acceptor = 0;  ///< heavy atoms, by index
  double length_A = 0.0;                  ///< distance between them
  friend bool operator==(const HydrogenBond&, const HydrogenBond&) = default;
};

/// Finds hydrogen bonds by heavy atoms alone, so that files with and without hydrogens give the same result. Criteria:
/// nitrogen and oxygen of two residues, at most 3.5 A apart, one a donor and one an acceptor. Every angle at either of
/// them, between the other and a bonded atom, is at least 90 degrees (E. N. Baker and R. E. Hubbard, Prog. Biophys.
/// Mol. Biol. 44, 97, 1984; I. K. McDonald and J. M. Thornton, J. Mol. Biol. 238, 777, 1994).
///
/// In amino acids and nucleotides the residue's chemical formula says which atoms donate and accept; elsewhere the bonds do. Each pair
/// occurs once, with the first atom as donor if both can donate; ordered by donor, then acceptor. `bonds` must result
/// from findBonds().
std::vector<HydrogenBond> findHydrogenBonds(const Molecule& molecule, const BondTable& bonds);

/// The hydrogen bonds between a held body and the rest of its molecule, by the same criteria. `spheres` are the molecule's
/// at their present places; its untouchable ones form no bonds. Built once for a body; at() is called for each pose.
class HeldHydrogenBonds {
 public:
  HeldHydrogenBonds(const Molecule& molecule, const SphereGrid& spheres, const HeldBody& body);

  /// The bonds of the body in this pose of its middle, in the order of findHydrogenBonds().
  std::vector<HydrogenBond> at(const PoseA& pose) const;

 private:
  struct Polar {
    std::uint32_t atom = 0;
    bool gives = false, takes = false;
    Vec3 place_A{0.0};             // of a body's atom: relative to its middle
    std::vector<Vec3> neighbours;  // places of the heavy atoms that are bonded to it, likewise
  };
  std::vector<Polar> scene_, body_;
  SphereGrid grid_;  // of scene_
};

}  // namespace moltact
