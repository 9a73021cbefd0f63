// Small molecules for the tests of lessons.
#pragma once

#include <algorithm>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace moltact {

/// Builds residues and atoms one after the other; a new chain or residue begins when its name or number changes.
struct MoleculeByHand {
  Molecule made;
  std::vector<PlacedAtom> atoms;
  std::vector<Residue> residues;
  std::vector<Chain> chains;

  Molecule molecule() const {
    Molecule out = made;
    out.setAtoms(atoms);
    out.residues = residues;
    out.chains = chains;
    return out;
  }

  MoleculeByHand& residue(std::string chain, std::string name, int number, ResidueKind kind, char insertion = ' ') {
    if (chains.empty() || chains.back().name != chain)
      chains.push_back({std::move(chain), static_cast<std::uint32_t>(residues.size()), 0});
    ++chains.back().residue_count;
    residues.push_back({std::move(name), number, insertion, static_cast<std::uint32_t>(chains.size() - 1),
                        static_cast<std::uint32_t>(atoms.size()), 0, kind});
    return *this;
  }
  MoleculeByHand& atom(std::string_view name, int atomic_number, Vec3 place, double radius_A = 1.7) {
    PlacedAtom a;
    a.position = {place};
    a.radius_A = radius_A;
    a.atomic_number = static_cast<std::uint8_t>(atomic_number);
    std::copy_n(name.begin(), std::min<std::size_t>(name.size(), 5), a.name.begin());
    if (!residues.empty()) {
      a.residue = static_cast<std::uint32_t>(residues.size() - 1);
      ++residues.back().atom_count;
    }
    atoms.push_back(a);
    return *this;
  }
};

/// Chain A: ASP 52 (N CA C O at x = 0 1 2 3) and ASP 52A (CA at x = 10); chain B: DA -1 (P at x = 20); HEM 1 (FE at x =
/// 6, NA at x = 7), water (O at x = 30), ZN (at x = 40).
inline Molecule mixedMolecule() {
  MoleculeByHand b;
  b.made.id = "mix";
  b.residue("A", "ASP", 52, ResidueKind::AminoAcid)
      .atom("N", 7, {0, 0, 0})
      .atom("CA", 6, {1, 0, 0})
      .atom("C", 6, {2, 0, 0})
      .atom("O", 8, {3, 0, 0});
  b.residue("A", "ASP", 52, ResidueKind::AminoAcid, 'A').atom("CA", 6, {10, 0, 0});
  b.residue("B", "DA", -1, ResidueKind::Nucleotide).atom("P", 15, {20, 0, 0});
  b.residue("B", "HEM", 1, ResidueKind::Ligand).atom("FE", 26, {6, 0, 0}).atom("NA", 7, {7, 0, 0});
  b.residue("B", "HOH", 2, ResidueKind::Water).atom("O", 8, {30, 0, 0});
  b.residue("B", "ZN", 3, ResidueKind::Ion).atom("ZN", 30, {40, 0, 0});
  return b.molecule();
}

}  // namespace moltact
