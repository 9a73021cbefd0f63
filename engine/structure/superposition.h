// Two states of one molecule: which atoms are the same, the turn and shift that lay one on the other, and the places
// between. Worked out when it is asked for, at a person's pace; pure functions, any thread but the haptic one. Units:
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

/// Atoms of two molecules that are the same: (index in one, index in the other), ascending by the first.
using AtomPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// By chain, residue number with its insertion code, and atom name; of an atom that is there twice the first. Residues of
/// another name at a number (a mutation) share the atoms of the same names. Chains go by their names, or where no name is
/// common to both and each has as many chains, by their order.
AtomPairs matchAtoms(const Molecule& one, const Molecule& other);

/// How the other lies on the one: place_in_one = rotation * place_in_other + shift.
struct Superposition {
  glm::dmat3 rotation{1.0};
  Vec3 shift_A{0.0};
  double rmsd_A = 0.0;     ///< of the atoms that were laid on one another
  std::size_t fitted = 0;  ///< how many these were
  Vec3 operator()(const Vec3& place_A) const { return rotation * place_A + shift_A; }
};

/// The least-squares fit (D. L. Theobald, Acta Cryst. A61, 478, 2005) over CA of amino acids and P or C1' of nucleotides
/// among the pairs; over all pairs where those are fewer than three. A Problem where fewer than three atoms are the same,
/// or they lie on a line.
Expected<Superposition> superpose(const Molecule& one, const Molecule& other,
                                  std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

/// A molecule in its own state and in another, superposed.
struct TwoStates {
  Superposition fit;
  std::size_t matched = 0;     ///< atoms that are in both
  std::vector<Sphere> first;   ///< one for each atom, where the file has it
  std::vector<Sphere> second;  ///< the same atoms in the other state, as the fit lays it on the first
  /// The spheres at a share (0 to 1) of the way; each goes straight on. Snapshots of it are what SphereMotion takes.
  std::vector<Sphere> at(double share) const;
};

/// The atoms of `one` in both states. An atom that `other` does not have goes the way of its residue, as far as that is
/// there: it keeps its place to the residue's matched atoms; a residue that is not there at all stays where it is. With
/// `on` (indices in `one`, ascending) only these atoms are laid on one another.
Expected<TwoStates> twoStates(const Molecule& one, const Molecule& other, std::span<const std::uint32_t> on = {});

}  // namespace moltact
