// The words of selections that stand for atoms by themselves: one row each.
#include "engine/language/catalogue.h"
#include "engine/lesson/selection_node.h"
#include "engine/molecule/molecule.h"
#include "engine/structure/accessible_area.h"
#include "engine/structure/amino_acids.h"
#include "engine/structure/ligands.h"
#include "engine/structure/secondary_structure.h"

namespace moltact {
namespace {

using Mask = std::vector<char>;

/// The atoms of the residues of which `belongs(residue, index)` is true.
template <class Belongs>
void markResidues(const Molecule& m, Mask& mask, Belongs&& belongs) {
  for (std::uint32_t r = 0; r < m.residues.size(); ++r) {
    const Residue& residue = m.residues[r];
    if (!belongs(residue, r)) continue;
    for (std::uint32_t i = residue.first_atom; i < residue.first_atom + residue.atom_count; ++i) mask[i] = 1;
  }
}

template <ResidueKind kind>
void ofKind(const Molecule& m, Mask& mask) {
  markResidues(m, mask, [](const Residue& r, std::uint32_t) { return r.kind == kind; });
}

template <SecondaryStructure kind>
void ofStructure(const Molecule& m, Mask& mask) {
  const MoleculeStructure s = secondaryStructure(m);
  markResidues(m, mask, [&](const Residue&, std::uint32_t r) { return s.of_residue[r] == kind; });
}

template <SideChain kind>
void ofSideChain(const Molecule& m, Mask& mask) {
  markResidues(m, mask, [](const Residue& r, std::uint32_t) {
    const AminoAcid* a = r.kind == ResidueKind::AminoAcid ? aminoAcid(r.name) : nullptr;
    return a && a->side_chain == kind;
  });
}

template <LigandClass kind>
void ofLigands(const Molecule& m, Mask& mask) {
  markResidues(m, mask, [](const Residue& r, std::uint32_t) {
    return r.kind == ResidueKind::Ligand && ligandClass(r.name) == kind;
  });
}

template <bool backbone>
void ofPolymer(const Molecule& m, Mask& mask) {
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (const PolymerPart part = polymerPart(m, static_cast<std::uint32_t>(i)); part != PolymerPart::None)
      mask[i] = (part == PolymerPart::Backbone) == backbone;
}

void accessible(const Molecule& m, Mask& mask) {
  const std::vector<bool> touched = accessibleBalls(m.balls());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = touched[i];
}

void metals(const Molecule& m, Mask& mask) {
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = isMetal(m.atoms[i].atomic_number);
}

constexpr AtomClass kClasses[] = {
    {"protein", "amino acid residues", N_("the protein"), N_("protein is not in {0}"), ofKind<ResidueKind::AminoAcid>},
    {"nucleic", "nucleotides", N_("the nucleic acid"), N_("nucleic acid is not in {0}"),
     ofKind<ResidueKind::Nucleotide>},
    {"water", "water molecules, where they were kept", N_("a water molecule"), N_("water is not in {0}"),
     ofKind<ResidueKind::Water>},
    {"ion", "single ions", N_("an ion"), N_("an ion is not in {0}"), ofKind<ResidueKind::Ion>},
    {"helix", "residues in helices, by the file's records, else by hydrogen bonds", N_("a helix"),
     N_("a helix is not in {0}"), ofStructure<SecondaryStructure::Helix>},
    {"sheet", "residues in the strands of sheets, by the file's records, else by hydrogen bonds", N_("a sheet"),
     N_("a sheet is not in {0}"), ofStructure<SecondaryStructure::Strand>},
    {"backbone", "of amino acids N, CA, C and O with their hydrogens, of nucleotides phosphate and sugar",
     N_("the backbone"), N_("a backbone is not in {0}"), ofPolymer<true>},
    {"sidechain", "of amino acids and nucleotides what is not backbone", N_("a side chain"),
     N_("a side chain is not in {0}"), ofPolymer<false>},
    {"hydrophobic", "Ala, Val, Leu, Ile, Pro, Met, Phe and Trp", N_("a hydrophobic residue"),
     N_("a hydrophobic residue is not in {0}"), ofSideChain<SideChain::Hydrophobic>},
    {"polar", "Ser, Thr, Asn, Gln, Tyr, Cys, His and Gly, which carry no charge at pH 7", N_("a polar residue"),
     N_("a polar residue is not in {0}"), ofSideChain<SideChain::Polar>},
    {"charged", "Asp, Glu, Lys and Arg", N_("a charged residue"), N_("a charged residue is not in {0}"),
     ofSideChain<SideChain::Charged>},
    {"surface", "atoms that a probe of 1.4 Å can touch", N_("an atom at the surface"),
     N_("no atom of {0} can be touched"), accessible},
    {"heme", "haems and their kin, by their residue names", N_("a haem"), N_("a haem is not in {0}"),
     ofLigands<LigandClass::Heme>},
    {"sugar", "sugars, by their residue names", N_("a sugar"), N_("a sugar is not in {0}"),
     ofLigands<LigandClass::Sugar>},
    {"buffer", "what crystals are grown and frozen in: sulfate, glycerol and so on", N_("a buffer molecule"),
     N_("a buffer molecule is not in {0}"), ofLigands<LigandClass::Buffer>},
    {"metal", "atoms of metals, as ions or in ligands", N_("a metal atom"), N_("a metal is not in {0}"), metals},
};

}  // namespace

std::span<const AtomClass> atomClasses() { return kClasses; }

}  // namespace moltact
