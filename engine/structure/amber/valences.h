// The valence of each atom of a ligand: hybridisation, formal charge and the number of its hydrogens that the file lacks.
// From the orders of the bonds where the file has them, else from lengths, angles and planar rings. Computed on request;
// any thread except the haptic one. Units: angstrom, elementary charge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

struct AtomValence {
  enum class Hybrid : std::uint8_t { Sp3, Sp2, Sp };
  Hybrid hybrid = Hybrid::Sp3;
  bool multiple = false;       ///< has a double, triple or aromatic bond
  bool conjugated = false;     ///< a nitrogen whose lone pair is conjugated (amide, aniline, pyrrole)
  bool sulfone = false;        ///< a sulphur with two or more oxygens that have no other neighbour
  std::uint8_t hydrogens = 0;  ///< that the file lacks
  float formal_e = 0.0f;       ///< a share of its group's charge, which is whole
};

/// One entry for each atom; those for which `wanted` is 0 keep the default. `bonds` are all bonds of the molecule
/// (findBonds). Rules:
/// * A residue with a hydrogen on a carbon lacks none. One with hydrogens on nitrogen, oxygen or sulphur only lacks those
///   on carbon.
/// * Where the file has no hydrogens, groups have the state that is usual in water at pH 7. Carboxylates, sulphates and
/// phosphates have no protons (two charges at the end of a phosphate); aliphatic amines, amidines and guanidines have
/// one more.
/// * A nitrogen on a metal without a proton, as in haem, has the charge -1. Metals have no entry.
std::vector<AtomValence> atomValences(const Molecule& molecule, std::span<const Bond> bonds,
                                      const std::vector<char>& wanted);

}  // namespace moltact
