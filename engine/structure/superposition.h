// Two states of one molecule: the corresponding atoms, the rotation and translation that superimpose them, and the
// positions between. Computed on request, not in a tick; pure functions, any thread except the haptic one. Units:
// angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/sphere.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Corresponding atoms of two molecules: (index in one, index in the other), ascending by the first.
using AtomPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Matches atoms by chain, residue number with insertion code, and atom name; of duplicates the first counts. Residues
/// with different names at one number (a mutation) share the atoms with equal names. Chains are matched by name; if no
/// name is common and the numbers of chains are equal, by order.
AtomPairs matchAtoms(const Molecule& one, const Molecule& other);

/// The atoms that represent residues: CA of amino acids, P or C1' of nucleotides; all atoms if those are fewer than three.
std::vector<std::uint32_t> leadingAtoms(const Molecule& molecule);

/// The rigid motion of the other molecule onto the one: place_in_one = rotation * place_in_other + shift.
struct Superposition {
  glm::dmat3 rotation{1.0};
  Vec3 shift_A{0.0};
  double rmsd_A = 0.0;     ///< of the fitted atoms
  std::size_t fitted = 0;  ///< number of fitted atoms
  Vec3 operator()(const Vec3& place_A) const { return rotation * place_A + shift_A; }
};

/// The least-squares fit (D. L. Theobald, Acta Cryst. A61, 478, 2005) over CA of amino acids and P or C1' of
/// nucleotides among the pairs; over all pairs if those are fewer than three. Returns a Problem if fewer than three
/// atoms correspond or the atoms are collinear. The second index of a pair is one of `other`.
Expected<Superposition> superpose(const Molecule& one, const Molecule& other,
                                  std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);
/// The same for positions alone. The second index of a pair is one of `other_A`.
Expected<Superposition> superpose(const Molecule& one, std::span<const Vec3> other_A,
                                  std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

/// A molecule in two superimposed states.
struct TwoStates {
  Superposition fit;
  std::size_t matched = 0;     ///< number of atoms present in both
  std::vector<Sphere> first;   ///< one per atom, as in the file
  std::vector<Sphere> second;  ///< the same atoms in the other state, after the fit
  /// The spheres at a fraction (0 to 1) of linear motion between the states, as snapshots for a SphereMotion.
  std::vector<Sphere> at(double share) const;
};

/// Computes both states of the atoms of `one`. An atom that `other` lacks moves rigidly with the matched atoms of its
/// residue; a residue without matched atoms does not move. With `on` (indices in `one`, ascending) the fit uses
/// only pairs of these atoms, selected as by superpose().
Expected<TwoStates> twoStates(const Molecule& one, const Molecule& other, std::span<const std::uint32_t> on = {});

}  // namespace moltact
