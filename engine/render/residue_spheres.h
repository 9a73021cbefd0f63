// The coarser form of a molecule of very many atoms: one sphere for each residue. The eye cannot tell the atoms of a virus
// capsid apart, and a sphere of its own for each takes some 700 bytes. Pure functions; any thread but the haptic one.
// Units: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// A picture of more atoms than this has one sphere for each residue, whatever the style.
inline constexpr std::size_t kMaxSingleAtoms = 2'000'000;

struct ResidueSpheres {
  std::vector<Sphere> spheres;
  std::vector<std::uint32_t> first_atom;  ///< of each sphere, and behind the last one the number of atoms
  double beyond_A = 0.0;                  ///< no atom reaches farther out of its sphere
};

/// Each sphere lies at the middle of its atoms and has the second moment that they have together, so that a sphere of one
/// atom is that atom. It stands for atoms that follow each other in the molecule: those of a residue, but at most 32, or at
/// most 8 of no residue, and none farther than 12 A from the first.
ResidueSpheres residueSpheres(const Molecule& molecule);

/// What is told to those who see a molecule of so many atoms; empty where each atom is drawn.
std::string residueSpheresNotice(std::size_t atoms, std::size_t most_single = kMaxSingleAtoms);

}  // namespace moltact
