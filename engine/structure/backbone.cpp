#include "engine/structure/backbone.h"

#include <string_view>

#include "engine/molecule/molecule.h"

namespace moltact {
namespace {

constexpr double kPeptideBond_A = 2.5, kPhosphateBond_A = 2.5;
constexpr double kNeighbourCa_A = 5.0, kNeighbourGuides_A = 9.0;

bool near(const Molecule& m, std::uint32_t a, std::uint32_t b, double reach_A) {
  return glm::distance(m.spheresAsRead()[a].centre_A, m.spheresAsRead()[b].centre_A) <= reach_A;
}

/// Stores the first atom of a name.
void keep(std::uint32_t& slot, std::uint32_t atom) {
  if (slot == kNoAtom) slot = atom;
}

AminoAcidAtoms aminoAcidAtoms(const Molecule& m, std::uint32_t residue) {
  AminoAcidAtoms out{residue};
  const Residue& r = m.residues[residue];
  for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) {
    const std::string_view name = m.atoms[i].nameText();
    if (name == "N") keep(out.n, i);
    if (name == "CA") keep(out.ca, i);
    if (name == "C") keep(out.c, i);
    if (name == "O" || name == "OT1" || name == "O1") keep(out.o, i);
  }
  return out;
}

NucleotideAtoms nucleotideAtoms(const Molecule& m, std::uint32_t residue) {
  NucleotideAtoms out{residue};
  const Residue& r = m.residues[residue];
  std::uint32_t n1 = kNoAtom, n3 = kNoAtom, n9 = kNoAtom;
  for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) {
    const std::string_view name = m.atoms[i].nameText();
    if (name == "P") keep(out.p, i);
    if (name == "O5'" || name == "O5*") keep(out.o5, i);
    if (name == "C1'" || name == "C1*") keep(out.c1, i);
    if (name == "O3'" || name == "O3*") keep(out.o3, i);
    if (name == "N1") keep(n1, i);
    if (name == "N3") keep(n3, i);
    if (name == "N9") keep(n9, i);
  }
  out.purine = n9 != kNoAtom;
  out.base = out.purine ? n1 : n3;
  return out;
}

bool follows(const Molecule& m, const AminoAcidAtoms& before, const AminoAcidAtoms& next) {
  if (before.c != kNoAtom && next.n != kNoAtom) return near(m, before.c, next.n, kPeptideBond_A);
  return near(m, before.ca, next.ca, kNeighbourCa_A);
}

bool follows(const Molecule& m, const NucleotideAtoms& before, const NucleotideAtoms& next) {
  if (before.o3 != kNoAtom && next.p != kNoAtom) return near(m, before.o3, next.p, kPhosphateBond_A);
  return near(m, before.guide(), next.guide(), kNeighbourGuides_A);
}

bool there(const AminoAcidAtoms& a) { return a.ca != kNoAtom; }
bool there(const NucleotideAtoms& a) { return a.guide() != kNoAtom; }

template <class Atoms>
std::vector<std::vector<Atoms>> stretches(const Molecule& m, ResidueKind kind,
                                          Atoms (*atomsOf)(const Molecule&, std::uint32_t)) {
  std::vector<std::vector<Atoms>> out;
  bool continued = false;
  for (std::uint32_t r = 0; r < m.residues.size(); ++r) {
    if (m.residues[r].kind != kind) {
      continued = false;
      continue;
    }
    const Atoms atoms = atomsOf(m, r);
    if (!there(atoms)) {
      continued = false;
      continue;
    }
    continued = continued && m.residues[r - 1].chain == m.residues[r].chain && follows(m, out.back().back(), atoms);
    if (!continued) out.emplace_back();
    out.back().push_back(atoms);
    continued = true;
  }
  return out;
}

}  // namespace

std::vector<ProteinStretch> proteinBackbone(const Molecule& molecule) {
  return stretches<AminoAcidAtoms>(molecule, ResidueKind::AminoAcid, aminoAcidAtoms);
}

std::vector<NucleicStretch> nucleicBackbone(const Molecule& molecule) {
  return stretches<NucleotideAtoms>(molecule, ResidueKind::Nucleotide, nucleotideAtoms);
}

}  // namespace moltact
