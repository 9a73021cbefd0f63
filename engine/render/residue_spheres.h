// A simplified molecule for very large numbers of atoms: one sphere per residue. The atoms of a virus capsid are too
// small to be distinguished, and drawing each takes about 700 bytes. Pure functions; any thread except the haptic one.
// Units: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// A picture with more atoms than this has one sphere per residue in every style.
inline constexpr std::size_t kMaxSingleAtoms = 2'000'000;

struct ResidueSpheres {
  std::vector<Sphere> spheres;
  std::vector<std::uint32_t> first_atom;  ///< per sphere; the last entry is the number of atoms
  double beyond_A = 0.0;                  ///< upper bound by which an atom extends beyond its sphere
};

/// Each sphere has the centre and the second moment of its atoms, so a single atom gives its own sphere. It represents
/// consecutive atoms: those of a residue, at most 32, or at most 8 without a residue, and none farther than 12 A from
/// the first.
ResidueSpheres residueSpheres(const Molecule& molecule);

/// The notice for users about a molecule with this number of atoms; empty if each atom is drawn.
std::string residueSpheresNotice(std::size_t atoms, std::size_t max_single = kMaxSingleAtoms);

}  // namespace moltact
