// Helices and strands: from the depositors' records, and from hydrogen bonds compared with another program.
#include "engine/structure/secondary_structure.h"

#include <algorithm>

#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// The records of the entries 1UBQ and 1HEL, as the files 1ubq.pdb of the Debian package freesasa 2.1.2-1 and 1hel.pdb of
// r-cran-bio3d 2.4-4-1 have them.
const std::string kUbiquitinRecords =
    "HELIX    1  H1 ILE A   23  GLU A   34  1                                  12    \n"
    "HELIX    2  H2 LEU A   56  TYR A   59  5                                   4    \n"
    "SHEET    1 BET 5 GLY A  10  VAL A  17  0                                        \n"
    "SHEET    2 BET 5 MET A   1  THR A   7 -1                                        \n"
    "SHEET    3 BET 5 GLU A  64  ARG A  72  1                                        \n"
    "SHEET    4 BET 5 GLN A  40  PHE A  45 -1                                        \n"
    "SHEET    5 BET 5 LYS A  48  LEU A  50 -1                                        \n";
const std::string kLysozymeRecords =
    "HELIX    1  H1 GLY A    4  GLY A   16  1                                  13    \n"
    "HELIX    2  H2 LEU A   25  PHE A   34  1                                  10    \n"
    "HELIX    3  H3 PRO A   79  LEU A   84  5                                   6    \n"
    "HELIX    4  H4 ILE A   88  SER A  100  1                                  13    \n"
    "HELIX    5  H5 GLY A  104  TRP A  108  5                                   5    \n"
    "HELIX    6  H6 VAL A  109  ARG A  114  1                                   6    \n"
    "HELIX    7  H7 VAL A  120  ILE A  124  5                                   5    \n"
    "SHEET    1  S1 3 ALA A  42  ASN A  46  0                                        \n"
    "SHEET    2  S1 3 GLY A  49  GLY A  54 -1  O  SER A  50   N  ASN A  46           \n"
    "SHEET    3  S1 3 LEU A  56  SER A  60 -1  O  SER A  60   N  THR A  51           \n";

// What mkdssp 4.2.2 (Debian 12) makes of the same coordinates, a letter a residue from the first on: H alpha, G 3-10,
// E strand, B bridge, T turn, S bend, P polyproline.
const std::string kUbiquitinDssp = ".EEEEEETTS.EEEEE..TTSBHHHHHHHHHHHH...GGGEEEEETTEEPPTTSBTGGGTPPTT.EEEEEE..S..";
const std::string kLysozymeDssp =
    ".B..HHHHHHHHHHTT.TTBTTB.HHHHHHHHHHHHTTBTT.EEE.TTS.EEETTTTEETTTT.B.S..TT...TT.SBGGGGGSSS.HHHHHHHHHHHHTSSGGGGS"
    "HHHHHHTTTS.GGGGGTT...";

std::string text(const MoleculeStructure& s, const Molecule& m) {
  std::string out;
  for (const StructureElement& e : s.elements) {
    out += e.kind == SecondaryStructure::Strand ? "E"
           : e.helix == HelixKind::ThreeTen     ? "G"
           : e.helix == HelixKind::Pi           ? "I"
           : e.helix == HelixKind::Alpha        ? "H"
                                                : "?";
    out += std::to_string(m.residues[e.first_residue].number) + "-" +
           std::to_string(m.residues[e.last_residue].number) + " ";
  }
  return out;
}

// A letter a residue: H, G, I, E; a point for the rest.
std::string letters(const MoleculeStructure& s) {
  std::string out(s.of_residue.size(), '.');
  for (const StructureElement& e : s.elements)
    for (std::uint32_t r = e.first_residue; r <= e.last_residue; ++r)
      out[r] = e.kind == SecondaryStructure::Strand ? 'E'
               : e.helix == HelixKind::ThreeTen     ? 'G'
               : e.helix == HelixKind::Pi           ? 'I'
                                                    : 'H';
  return out;
}

std::string withoutTurns(std::string dssp) {
  for (char& c : dssp)
    if (c != 'H' && c != 'G' && c != 'I' && c != 'E') c = '.';
  return dssp;
}

std::string proteinOf(const std::string& file) { return libraryText(file); }

}  // namespace

TEST_CASE(
    "where a file has no records, 1UBQ and 1HEL have the helices and strands that mkdssp finds, residue by residue") {
  for (const auto& [file, dssp] : {std::pair{"1ubq.pdb", &kUbiquitinDssp}, std::pair{"1hel.pdb", &kLysozymeDssp}}) {
    const Molecule m = libraryMolecule(file);
    REQUIRE_FALSE(m.has_recorded_structure);
    const MoleculeStructure s = secondaryStructure(m);
    CHECK(s.source == MoleculeStructure::Source::HydrogenBonds);
    CHECK(letters(s).substr(0, dssp->size()) == withoutTurns(*dssp));
  }
}

TEST_CASE("records of 1UBQ and 1HEL are taken as they stand") {
  const Molecule ubiquitin = moleculeOf(kUbiquitinRecords + proteinOf("1ubq.pdb"));
  REQUIRE(ubiquitin.has_recorded_structure);
  const MoleculeStructure u = secondaryStructure(ubiquitin);
  CHECK(u.source == MoleculeStructure::Source::File);
  CHECK(text(u, ubiquitin) == "E1-7 E10-17 H23-34 E40-45 E48-50 G56-59 E64-72 ");
  CHECK(ubiquitin.warnings == libraryMolecule("1ubq.pdb").warnings);
  const Molecule lysozyme = moleculeOf(kLysozymeRecords + proteinOf("1hel.pdb"));
  CHECK(text(secondaryStructure(lysozyme), lysozyme) ==
        "H4-16 H25-34 E42-46 E49-54 E56-60 G79-84 H88-100 G104-108 H109-114 G120-124 ");
}

TEST_CASE(
    "hydrogen bonds give the depositors' helices and strands: each in 40 % of its residues or more, at most one of "
    "another kind") {
  for (const auto& [file, records] :
       {std::pair{"1ubq.pdb", &kUbiquitinRecords}, std::pair{"1hel.pdb", &kLysozymeRecords}}) {
    const Molecule m = moleculeOf(*records + proteinOf(file));
    const MoleculeStructure recorded = secondaryStructure(m), found = structureByHydrogenBonds(m);
    for (const StructureElement& e : recorded.elements) {
      CAPTURE(m.residues[e.first_residue].number);
      int same = 0, other = 0;
      for (std::uint32_t r = e.first_residue; r <= e.last_residue; ++r) {
        same += found.of_residue[r] == e.kind;
        other += found.of_residue[r] != e.kind && found.of_residue[r] != SecondaryStructure::Coil;
      }
      // Gln 40 of ubiquitin, which begins a strand of the records, ends a 3-10 helix; of lysozyme's strand 56-60 two
      // residues have the bonds of a ladder.
      CHECK(other <= 1);
      CHECK(same * 5 >= 2 * int(e.last_residue - e.first_residue + 1));
    }
  }
}

TEST_CASE("an ideal helix of 20 alanines is one alpha helix, of all residues but two at either end or so") {
  const Molecule m = libraryMolecule("alpha-helix.pdb");
  const MoleculeStructure s = secondaryStructure(m);
  REQUIRE(s.elements.size() == 1);
  CHECK(text(s, m) == "H2-19 ");
}

TEST_CASE("copies of an assembly have the helices of what they are copied from, and DNA has none") {
  const std::string assembly =
      "REMARK 350 BIOMOLECULE: 1                                                       \n"
      "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A                                     \n"
      "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000            \n"
      "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000            \n"
      "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000            \n"
      "REMARK 350   BIOMT1   2  1.000000  0.000000  0.000000      100.00000            \n"
      "REMARK 350   BIOMT2   2  0.000000  1.000000  0.000000        0.00000            \n"
      "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000            \n";
  const Molecule m = moleculeOf(assembly + kUbiquitinRecords + proteinOf("1ubq.pdb"), "x.pdb", {.assembly = "1"});
  CHECK(m.atoms.size() == 1204);
  const std::string once = "E1-7 E10-17 H23-34 E40-45 E48-50 G56-59 E64-72 ";
  CHECK(text(secondaryStructure(m), m) == once + once);
  CHECK(secondaryStructure(libraryMolecule("b-dna.pdb")).elements.empty());
}

TEST_CASE("two helices that follow upon one another stay two; a strand of two sheets stays one") {
  const Molecule m = moleculeOf(
      "HELIX    1  H1 ILE A   23  ILE A   30  1                                   8    \n"
      "HELIX    2  H2 GLN A   31  GLU A   34  1                                   4    \n"
      "SHEET    1 BET 2 GLY A  10  VAL A  17  0                                        \n"
      "SHEET    1 BEU 2 THR A  12  VAL A  17  0                                        \n" +
      proteinOf("1ubq.pdb"));
  CHECK(text(secondaryStructure(m), m) == "E10-17 H23-30 H31-34 ");
}

TEST_CASE(
    "records that name what is not there, or nothing, are reported and left out; hydrogen bonds then "
    "take their place") {
  const Molecule m = moleculeOf(
      "HELIX    1  H1 ILE B   23  GLU B   34  1                                  12    \n"
      "HELIX    2  H2 ILE A  xx3  GLU A   34  1                                  12    \n" +
      proteinOf("1ubq.pdb"));
  CHECK_FALSE(m.has_recorded_structure);
  const auto reported = [&](const std::string& what) {
    return std::count(m.warnings.begin(), m.warnings.end(), what) == 1;
  };
  CHECK(reported("Line 2: the helix or strand names no residues and was left out."));
  CHECK(reported("1 helix or strand of the file's records names residues that are not among the atoms."));
  CHECK(secondaryStructure(m).elements.size() > 5);
}

TEST_CASE("mmCIF's tables of helices and strands are read, by authors' numbers") {
  std::string cif =
      "data_X\nloop_\n_struct_conf.conf_type_id\n_struct_conf.beg_auth_asym_id\n_struct_conf.beg_auth_seq_id\n"
      "_struct_conf.pdbx_beg_PDB_ins_code\n_struct_conf.end_auth_seq_id\n_struct_conf.pdbx_end_PDB_ins_code\n"
      "_struct_conf.pdbx_PDB_helix_class\n"
      "HELX_P A 1 ? 2 ? 1\nHELX_P A 3 ? 4 ? 5\nTURN_P A 5 ? 6 ? ?\nHELX_P A 8 ? oops ? 1\n"
      "_struct_sheet_range.beg_auth_asym_id A\n_struct_sheet_range.beg_auth_seq_id 6\n"
      "_struct_sheet_range.end_auth_seq_id 7\n_struct_sheet_range.pdbx_end_PDB_ins_code A\n"
      "loop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.type_symbol\n"
      "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n"
      "_atom_site.pdbx_PDB_ins_code\n_atom_site.B_iso_or_equiv\n";
  for (int i = 1; i <= 8; ++i)
    cif += std::to_string(4 * i) + " 0 0 C CA ALA A " + std::to_string(i) + (i == 7 ? " A " : " ? ") +
           std::to_string(10 * i) + ".5\n";
  const Molecule m = moleculeOf(cif, "x.cif");
  CHECK(text(secondaryStructure(m), m) == "H1-2 G3-4 E6-7 ");
  CHECK(m.warnings == std::vector<std::string>{"A helix or strand of chain 'A' names no residues and was left out."});
  CHECK(m.atoms[2].b_factor_A2 == doctest::Approx(30.5));
}
