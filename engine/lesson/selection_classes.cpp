// The selection words that need no argument, one row each.
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

/// Marks the atoms of the residues for which `belongs(residue, index)` returns true.
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
  const std::vector<bool> touched = accessibleSpheres(m.spheres);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = touched[i];
}

void metals(const Molecule& m, Mask& mask) {
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = isMetal(m.atoms[i].atomic_number);
}

constexpr AtomClass kClasses[] = {
    {.word = "protein",
     .meaning = "amino acid residues",
     .noun = N_("the protein"),
     .missing = N_("protein is not in {0}"),
     .mark = ofKind<ResidueKind::AminoAcid>},
    {.word = "nucleic",
     .meaning = "nucleotides",
     .noun = N_("the nucleic acid"),
     .missing = N_("nucleic acid is not in {0}"),
     .mark = ofKind<ResidueKind::Nucleotide>},
    {.word = "water",
     .meaning = "water molecules, where they were kept",
     .noun = N_("a water molecule"),
     .missing = N_("water is not in {0}"),
     .mark = ofKind<ResidueKind::Water>},
    {.word = "ion",
     .meaning = "single ions",
     .noun = N_("an ion"),
     .missing = N_("an ion is not in {0}"),
     .mark = ofKind<ResidueKind::Ion>},
    {.word = "helix",
     .meaning = "residues in helices, by the file's records, else by hydrogen bonds",
     .noun = N_("a helix"),
     .missing = N_("a helix is not in {0}"),
     .mark = ofStructure<SecondaryStructure::Helix>},
    {.word = "sheet",
     .meaning = "residues in the strands of sheets, by the file's records, else by hydrogen bonds",
     .noun = N_("a sheet"),
     .missing = N_("a sheet is not in {0}"),
     .mark = ofStructure<SecondaryStructure::Strand>},
    {.word = "backbone",
     .meaning = "of amino acids N, CA, C and O with their hydrogens, of nucleotides phosphate and sugar",
     .noun = N_("the backbone"),
     .missing = N_("a backbone is not in {0}"),
     .mark = ofPolymer<true>},
    {.word = "sidechain",
     .meaning = "everything of amino acids and nucleotides that is not backbone",
     .noun = N_("a side chain"),
     .missing = N_("a side chain is not in {0}"),
     .mark = ofPolymer<false>},
    {.word = "hydrophobic",
     .meaning = "Ala, Val, Leu, Ile, Pro, Met, Phe and Trp",
     .noun = N_("a hydrophobic residue"),
     .missing = N_("a hydrophobic residue is not in {0}"),
     .mark = ofSideChain<SideChain::Hydrophobic>},
    {.word = "polar",
     .meaning = "Ser, Thr, Asn, Gln, Tyr, Cys, His and Gly, which carry no charge at pH 7",
     .noun = N_("a polar residue"),
     .missing = N_("a polar residue is not in {0}"),
     .mark = ofSideChain<SideChain::Polar>},
    {.word = "charged",
     .meaning = "Asp, Glu, Lys and Arg",
     .noun = N_("a charged residue"),
     .missing = N_("a charged residue is not in {0}"),
     .mark = ofSideChain<SideChain::Charged>},
    {.word = "surface",
     .meaning = "atoms that a probe of 1.4 Å can touch",
     .noun = N_("an atom at the surface"),
     .missing = N_("no atom of {0} can be touched"),
     .mark = accessible},
    {.word = "heme",
     .meaning = "haems and similar groups, by their residue names",
     .noun = N_("a haem"),
     .missing = N_("a haem is not in {0}"),
     .mark = ofLigands<LigandClass::Heme>},
    {.word = "sugar",
     .meaning = "sugars, by their residue names",
     .noun = N_("a sugar"),
     .missing = N_("a sugar is not in {0}"),
     .mark = ofLigands<LigandClass::Sugar>},
    {.word = "buffer",
     .meaning = "substances for crystal growth and freezing: sulfate, glycerol and so on",
     .noun = N_("a buffer molecule"),
     .missing = N_("a buffer molecule is not in {0}"),
     .mark = ofLigands<LigandClass::Buffer>},
    {.word = "metal",
     .meaning = "atoms of metals, as ions or in ligands",
     .noun = N_("a metal atom"),
     .missing = N_("a metal is not in {0}"),
     .mark = metals},
};

}  // namespace

std::span<const AtomClass> atomClasses() { return kClasses; }

}  // namespace moltact
