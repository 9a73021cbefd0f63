// MOL and SDF, PQR, GRO, the CIF of small molecules, and extensions of the PDB format by other programs.
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

Molecule formatsRead(const std::string& text, const std::string& name, const ReadOptions& options = {}) {
  auto molecule = readMoleculeBytes(text, name, options);
  if (!molecule) FAIL(molecule.problem().text());
  return *std::move(molecule);
}

std::string places(const Molecule& m) {
  std::string out;
  for (const PlacedAtom& a : m.placedAtoms()) {
    char text[96];
    std::snprintf(text, sizeof text, "%s%s %.3f %.3f %.3f", out.empty() ? "" : "|", a.name.data(), a.position.A.x,
                  a.position.A.y, a.position.A.z);
    out += text;
  }
  return out;
}

std::string bonds(const Molecule& m) {
  std::string out;
  for (const Bond& b : m.listed_bonds)
    out += std::to_string(b.first) + "-" + std::to_string(b.second) + ":" + std::to_string(int(b.order)) + " ";
  return out;
}

const std::string kEthyne =
    "7777\n  own               3D\n\n"
    "  4  3  0     0  0  0  0  0  0999 V2000\n"
    "    0.6000    0.0000    0.0000 C   0  0  0\n"
    "   -0.6000    0.0000    0.0000 C   0  0  0\n"
    "    1.6600    0.0000    0.0000 H   0  0  0\n"
    "   -1.6600    0.0000    0.0000 D   0  0  0\n"
    "  2  1  3  0\n  1  3  1  0\n  2  4  1  0\n"
    "M  CHG  1   1   1\nM  END\n"
    "> <PUBCHEM_COMPOUND_CID>\n7777\n\n> <PUBCHEM_IUPAC_NAME>\nethyne\n\n$$$$\n";

const std::string kWater3000 =
    "\n\n\n  0  0  0     0  0            999 V3000\n"
    "M  V30 BEGIN CTAB\nM  V30 COUNTS 3 2 0 0 0\nM  V30 BEGIN ATOM\n"
    "M  V30 10 O 0 0 0 0\nM  V30 20 H 0.757 0.586 -\nM  V30 0 0 CFG=1\nM  V30 5 H -0.757 0.586 0 0\n"
    "M  V30 END ATOM\nM  V30 BEGIN BOND\nM  V30 1 1 10 20\nM  V30 2 1 5 10\nM  V30 END BOND\n"
    "M  V30 END CTAB\nM  END\n";

}  // namespace

TEST_CASE("an SDF file of version 2000 gives its atoms, its bonds with their orders, its name and number") {
  const Molecule m = formatsRead(kEthyne, "x.sdf");
  CHECK(places(m) == "C1 0.600 0.000 0.000|C2 -0.600 0.000 0.000|H1 1.660 0.000 0.000|D2 -1.660 0.000 0.000");
  CHECK(bonds(m) == "0-1:3 0-2:1 1-3:1 ");
  CHECK(m.id == "7777");
  CHECK(m.title == "ethyne");
  CHECK(m.atoms[3].atomic_number == 1);
  REQUIRE(m.residues.size() == 1);
  CHECK(m.residues[0].kind == ResidueKind::Ligand);
  CHECK(m.residues[0].name == "UNL");
  CHECK(m.warnings.empty());
  CHECK(formatsRead(kEthyne, "no-ending").atoms.size() == 4);
  CHECK(formatsRead(gzipped(kEthyne), "x.mol.gz").atoms.size() == 4);
}

TEST_CASE("a MOL file of version 3000 is read, with lines that continue and atoms numbered as they like") {
  const Molecule m = formatsRead(kWater3000, "x.mol");
  CHECK(places(m) == "O1 0.000 0.000 0.000|H1 0.757 0.586 0.000|H2 -0.757 0.586 0.000");
  CHECK(bonds(m) == "0-1:1 0-2:1 ");
  CHECK(m.id == "x");
}

TEST_CASE("each molecule of an SDF file is a model; a flat drawing is reported") {
  std::string flat = kEthyne;
  flat.replace(flat.find("3D"), 2, "2D");
  const std::string both = kEthyne + flat;
  CHECK(formatsRead(both, "x.sdf").warnings == std::vector<std::string>{"The file has 2 models; this is model 1."});
  const Molecule second = formatsRead(both, "x.sdf", {.model = 2});
  CHECK(bonds(second) == "0-1:3 0-2:1 1-3:1 ");
  CHECK(second.title == "ethyne");
  REQUIRE(second.warnings.size() == 2);
  CHECK(second.warnings[1].starts_with("The file is a flat drawing: "));
  CHECK(problemOf(both, "x.sdf", {.model = 3}).starts_with("x.sdf: there is no model 3; the file has 2 models"));
}

TEST_CASE("errors in a MOL or SDF file are reported at their place") {
  const auto with = [](const std::string& from, const std::string& to, const std::string& text) {
    std::string out = text;
    out.replace(out.find(from), from.size(), to);
    return problemOf(out, "x.sdf");
  };
  const std::string again = "; take the file again from its source, or write it anew with the program that made it";
  CHECK(
      with("  4  3  0", "  4  x  0", kEthyne) ==
      "x.sdf:4:1: the fourth line of a molecule says how many atoms and bonds it has, in columns 1-6; this is '  4  x  "
      "0     0  0  0  0...'" +
          again);
  CHECK(with("   -0.6000    0.0000", "   -0.6000    zero  ", kEthyne) ==
        "x.sdf:6:11: y is not a number: '    zero  '" + again);
  CHECK(with("  1  3  1  0", "  1  9  1  0", kEthyne) ==
        "x.sdf:10:1: a bond names the atom 9, which is not there" + again);
  CHECK(with("  1  3  1  0", "  1  1  1  0", kEthyne) == "x.sdf:10:1: the atom 1 is bonded to itself" + again);
  CHECK(
      with("  1  3  1  0", "  1  -  1  0", kEthyne).starts_with("x.sdf:10:1: a bond is three numbers in columns 1-9"));
  CHECK(problemOf(kEthyne.substr(0, kEthyne.find("   -1.66")), "x.sdf") ==
        "x.sdf:7: the file ends within a molecule; copy or download it again");
  CHECK(with("M  V30 2 1 5 10", "M  V30 2 1 5 11", kWater3000) ==
        "x.sdf:15:8: a bond names the atom 11, which is not there" + again);
  CHECK(with("M  V30 10 O 0 0 0 0", "M  V30 10 O 0 0", kWater3000)
            .starts_with("x.sdf:8:8: an atom is its number, its element and x, y, z"));
  CHECK(with("M  V30 5 H", "M  V30 20 H", kWater3000).starts_with("x.sdf:11:8: two atoms have the number 20"));
  CHECK(problemOf(kEthyne, "x.sdf", {.assembly = "1"}) ==
        "x.sdf: a file of this format describes no biological assembly; read it without one, or take the PDB or mmCIF "
        "file");
  CHECK(problemOf("\n\n", "x.sdf") == "x.sdf: the file is empty; copy or download it again");
  CHECK(problemOf("name\n", "x.sdf") == "x.sdf:1: the file ends within a molecule; copy or download it again");
  CHECK(formatsRead(kEthyne + "\n\n\n\n\n", "x.sdf").models_in_file == 1);
}

TEST_CASE("PQR gives each atom the radius and the charge of the file; the chain may be left out") {
  const Molecule m = formatsRead(
      "REMARK own\nATOM      1  N   ALA A   1       1.000   2.000   3.000 -0.3000 1.8240\n"
      "ATOM      2  HB1 ALA A   1       2.000   2.000   3.000  0.1000 0.0000\n"
      "HETATM10000  NA  NA    2A      9.000   2.000   3.000  1.0000 1.8680\nEND\n",
      "x.pqr");
  CHECK(places(m) == "N 1.000 2.000 3.000|HB1 2.000 2.000 3.000|NA 9.000 2.000 3.000");
  CHECK(m.spheres[0].radius_A == 1.824);
  CHECK(m.spheres[1].radius_A == 0.0);
  CHECK(m.charges_e == SharedArray<float>{-0.3F, 0.1F, 1.0F});
  CHECK(m.atoms[0].atomic_number == 7);
  CHECK(m.atoms[1].atomic_number == 1);
  CHECK(m.atoms[2].atomic_number == 11);
  CHECK(m.residues[1].kind == ResidueKind::Ion);
  CHECK(m.residues[1].insertion == 'A');
  CHECK(m.chains[0].name == "A");
  CHECK(m.warnings.empty());
}

TEST_CASE("the element after the radius in a PQR file of Open Babel counts more than the name") {
  const Molecule m =
      formatsRead("HETATM 1 CA LIG A 1 1 2 3 -0.3 1.8 Ca\nHETATM 2 CA LIG 1 1 2 6 -0.3 1.8 C\n", "x.pqr");
  CHECK(m.atoms[0].atomic_number == 20);
  CHECK(m.atoms[1].atomic_number == 6);
  CHECK(m.spheres[1].centre_A == Vec3(1, 2, 6));
  CHECK(problemOf("ATOM 1 N ALA A 1 1 2 3 -0.3 nan\n", "x.pqr")
            .starts_with("x.pqr:1:29: expected a number for the radius, found 'nan'"));
  CHECK(problemOf("ATOM 1 N ALA A 1 1 2 3 nan 1.8\n", "x.pqr")
            .starts_with("x.pqr:1:24: expected a number for the charge, found 'nan'"));
  CHECK(problemOf("ATOM 1 N ALA A 1 1 2 3 -1e20 1.8\n", "x.pqr")
            .starts_with("x.pqr:1:24: the charge '-1e20' is not from -100 to 100"));
}

TEST_CASE("errors in a PQR file are reported at their place") {
  const std::string remedy =
      "; write: ATOM number name residue chain residue-number x y z charge radius, with blanks between them (pdb2pqr "
      "--whitespace); the chain may be left out";
  CHECK(problemOf("ATOM 1 N ALA 1 1 2 3 -0.3\n", "x.pqr") ==
        "x.pqr:1: an atom has 9 or 10 words after its record's name, this one 8" + remedy);
  CHECK(problemOf("ATOM 1 N ALA 1 1 2 three -0.3 1.8\n", "x.pqr") ==
        "x.pqr:1:20: expected a number for z, found 'three'" + remedy);
  CHECK(problemOf("ATOM 1 N ALA 1 1 2 3 -0.3 -1.8\n", "x.pqr")
            .starts_with("x.pqr:1:27: the radius '-1.8' is not from 0"));
  CHECK(problemOf("ATOM 1 N ALA x 1 2 3 -0.3 1.8\n", "x.pqr") ==
        "x.pqr:1:14: the residue number is not a number: 'x'" + remedy);
  CHECK(problemOf("REMARK\n", "x.pqr") == "x.pqr: there is no ATOM or HETATM line in it" + remedy);
}

TEST_CASE("GRO is read in angstroms, frame by frame; points without mass are left out, ions are ions") {
  const std::string frames =
      "water t=   0.00000\n    5\n"
      "    1SOL     OW    1   0.126   1.624   1.679  0.1227 -0.0580  0.0434\n"
      "    1SOL    HW1    2   0.190   1.661   1.747\n"
      "    1SOL    HW2    3   0.177   1.568   1.613\n"
      "    1SOL     MW    4   0.130   1.620   1.680\n"
      "    2NA      NA    5   0.500   0.500   0.500\n"
      "   1.82060   1.82060   1.82060\n"
      "later\n    2\n    1LIG    CL1    1   1.00001  -2.00000   3.12341\n    1LIG     C2    2   1.10000  -2.00000   "
      "3.00000\n   1.8 1.8 1.8\n\n";
  const Molecule m = formatsRead(frames, "x.gro", {.waters = true});
  CHECK(places(m) == "OW 1.260 16.240 16.790|HW1 1.900 16.610 17.470|HW2 1.770 15.680 16.130|NA 5.000 5.000 5.000");
  CHECK(m.residues[0].kind == ResidueKind::Water);
  CHECK(m.residues[1].kind == ResidueKind::Ion);
  CHECK(m.atoms[3].atomic_number == 11);
  CHECK(m.title == "water t=   0.00000");
  CHECK(m.models_in_file == 2);
  const Molecule later = formatsRead(frames, "x.gro", {.model = 2});
  CHECK(places(later) == "CL1 10.000 -20.000 31.234|C2 11.000 -20.000 30.000");
  CHECK(later.atoms[0].atomic_number == 17);
  CHECK(later.residues[0].kind == ResidueKind::Ligand);
}

TEST_CASE("residue 99999 of a GRO file is followed by 100000") {
  const Molecule m = formatsRead(
      "many\n    2\n99999SOL     OW    1   0.126   1.624   1.679\n    0SOL     OW    2   0.500   1.624   "
      "1.679\n   1 1 1\n",
      "x.gro", {.waters = true});
  REQUIRE(m.residues.size() == 2);
  CHECK(m.residues[1].number == 100'000);
}

TEST_CASE("errors in a GRO file are reported at their place") {
  const std::string line = "    1SOL     OW    1   0.126   1.624   1.679\n";
  CHECK(problemOf("t\nfive\n" + line, "x.gro") ==
        "x.gro:2:1: the number of atoms is not a number: 'five'; the second line of a frame is how many atoms it has");
  CHECK(problemOf("t\n    3\n" + line + line, "x.gro") ==
        "x.gro:4: the frame from line 2 on is to have 3 atoms, and the file ends after 2; copy or download it again");
  CHECK(problemOf("t\n    1\n    1SOL     OW    1   0.126   1.6x4   1.679\nbox\n", "x.gro")
            .starts_with("x.gro:3:29: y is not a number: '   1.6x4'; an atom is residue number (5 columns)"));
  CHECK(problemOf("t\n    1\n    xSOL     OW    1   0.126   1.624   1.679\nbox\n", "x.gro")
            .starts_with("x.gro:3:1: the residue number is not a number: '    x'"));
  CHECK(problemOf("t\n    1\n    1SOL\nbox\n", "x.gro").starts_with("x.gro:3:9: the atom's line ends before"));
}

namespace {

const std::string kSaltCell =
    "data_salt\n_chemical_name_mineral 'Rock salt'\n_cell_length_a 5.64(1)\n_cell_length_b 5.64\n_cell_length_c 5.64\n"
    "_cell_angle_alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 90\n";
// The four points of a face-centred lattice.
const std::string kSaltSymmetry =
    "loop_\n_space_group_symop_id\n_space_group_symop_operation_xyz\n1 x,y,z\n2 'x, y+1/2, z+1/2'\n3 x+1/2,y,z+1/2\n"
    "4 x+1/2,y+1/2,z\n";
const std::string kSaltAtoms =
    "loop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
    "_atom_site_U_iso_or_equiv\nNa1 Na1+ 0 0 0 0.02\nCl1 Cl1- 0.5 0 0 0.02(1)\n";

}  // namespace

TEST_CASE("the CIF of rock salt gives two ions, its cell eight at the places of the lattice") {
  const Molecule m = formatsRead(kSaltCell + kSaltSymmetry + kSaltAtoms, "x.cif");
  CHECK(places(m) == "Na1 0.000 0.000 0.000|Cl1 2.820 0.000 0.000");
  CHECK(m.id == "salt");
  CHECK(m.title == "Rock salt");
  CHECK(m.atoms[1].atomic_number == 17);
  CHECK(m.atoms[0].b_factor_A2 == doctest::Approx(0.02 * 8 * 9.8696));
  REQUIRE(m.warnings.size() == 1);
  CHECK(m.warnings[0] == "These are the atoms of the asymmetric unit; the assembly 'cell' is the whole unit cell.");
  const Molecule cell = formatsRead(kSaltCell + kSaltSymmetry + kSaltAtoms, "x.cif", {.assembly = "cell"});
  CHECK(cell.atoms.size() == 8);
  std::set<std::string> seen;
  for (const PlacedAtom& a : cell.placedAtoms()) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double half = a.position.A[k] / 2.82;
      CHECK(std::abs(half - std::round(half)) < 1e-9);
      sum += std::round(half);
    }
    // Sodium where the sum of the half steps is even, chlorine where it is odd.
    CHECK((std::lround(sum) % 2 == 0) == (a.atomic_number == 11));
    char text[64];
    std::snprintf(text, sizeof text, "%.2f %.2f %.2f", a.position.A.x, a.position.A.y, a.position.A.z);
    CHECK(seen.insert(text).second);
  }
}

TEST_CASE("in an oblique cell two atoms lie as far apart as the cell's metric says") {
  const std::string cif =
      "data_x\n_cell_length_a 6\n_cell_length_b 7\n_cell_length_c 8\n_cell_angle_alpha 80\n_cell_angle_beta 100\n"
      "_cell_angle_gamma 110\nloop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
      "O1W 0.1 0.2 0.3\nFe1 0.4 0.1 0.7\nC99 ? . .\n";
  const Molecule m = formatsRead(cif, "x.cif");
  REQUIRE(m.atoms.size() == 2);
  CHECK(m.atoms[0].atomic_number == 8);
  CHECK(m.atoms[1].atomic_number == 26);
  CHECK(m.warnings == std::vector<std::string>{"1 atom without a place left out."});
  const double u = 0.3 * 6, v = -0.1 * 7, w = 0.4 * 8, degree = 3.14159265358979323846 / 180;
  const double squared = u * u + v * v + w * w + 2 * v * w * std::cos(80 * degree) +
                         2 * u * w * std::cos(100 * degree) + 2 * u * v * std::cos(110 * degree);
  CHECK(glm::distance(m.spheres[0].centre_A, m.spheres[1].centre_A) == doctest::Approx(std::sqrt(squared)));
}

TEST_CASE("of disorder groups the most occupied is kept; a second block of atoms is a second model") {
  const std::string head =
      "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
      "_atom_site_occupancy\n_atom_site_disorder_group\n";
  std::string cell = kSaltCell;
  const std::string one = cell + head + "C1 0 0 0 1 .\nC2A .1 0 0 0.4 1\nC3A .2 0 0 0.4 1\nC2B .1 .1 0 0.6 2\n";
  cell.replace(cell.find("data_salt"), 9, "data_next");
  const std::string two = one + cell + head + "N1 0 0 0 1 .\n";
  const Molecule m = formatsRead(one, "x.cif");
  CHECK(places(m) == "C1 0.000 0.000 0.000|C2B 0.564 0.564 0.000");
  CHECK(m.warnings == std::vector<std::string>{"2 atoms of less occupied disorder groups left out."});
  const Molecule next = formatsRead(two, "x.cif", {.model = 2});
  CHECK(places(next) == "N1 0.000 0.000 0.000");
  CHECK(next.id == "next");
}

TEST_CASE("errors in the CIF of a small molecule are reported at their place") {
  CHECK(problemOf(kSaltCell +
                      "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\nNa1 0 "
                      "zero 0\n",
                  "x.cif") ==
        "x.cif:14:7: it is not sound CIF: _atom_site_fract_y is not a number: 'zero'; correct the file, or take it "
        "again "
        "from its source");
  CHECK(problemOf("data_x\n_cell_length_a 5\n" + kSaltAtoms, "x.cif") ==
        "x.cif: the unit cell is not whole: three lengths and three angles are needed; correct the file, or take it "
        "again "
        "from its source");
  std::string flat = kSaltCell + kSaltAtoms;
  flat.replace(flat.find("alpha 90"), 8, "alpha 180");
  CHECK(problemOf(flat, "x.cif").starts_with("x.cif: no unit cell has these lengths and angles"));
  CHECK(problemOf(kSaltCell, "x.cif").starts_with("x.cif: there is no atom with _atom_site_fract_x, _y and _z in it"));
  std::string odd = kSaltCell + kSaltSymmetry + kSaltAtoms;
  odd.replace(odd.find("x+1/2,y,z+1/2"), 13, "x+1/2,y,q+1/2");
  CHECK(problemOf(odd, "x.cif", {.assembly = "cell"}) ==
        "x.cif: 'x+1/2,y,q+1/2' is no symmetry operation; write one like -x,y+1/2,-z");
  CHECK(problemOf(odd, "x.cif", {.assembly = "1"}) ==
        "x.cif: there is no biological assembly '1'; a crystal of small molecules has the assembly 'cell', its whole "
        "unit "
        "cell");
}

TEST_CASE("a zip archive and binary formats are rejected as molecules, and the message names the format") {
  const std::string stored = std::string("PK\x03\x04\x0a\0\0\0\0\0", 10) + "1abc.pdb\n" +
                             atomLine(" CA", ' ', "ALA", 'A', 1, ' ', 0, 0, 0, 1, "C") + "END\n";
  for (const char* name : {"x.pdb", "x.zip", "x"})
    CHECK(problemOf(stored, name) ==
          std::string(name) + ": it is a zip archive; unpack it, and open the molecule's file that is in it");
  CHECK(problemOf("\x84\xa7", "x.bcif") ==
        "x.bcif: binary files of molecules are not read; take the .cif file of the entry");
}

TEST_CASE("in a PDB file residue 9999 is followed by 10000, as GROMACS and as VMD write it, in one chain") {
  const auto line = [](const char* number, double x) {
    char out[96];
    std::snprintf(out, sizeof out, "ATOM  %5d  OW  SOL  %5s   %8.3f%8.3f%8.3f  1.00  0.00           O\n", 1, number, x,
                  0.0, 0.0);
    return std::string(out);
  };
  // GROMACS: 9999, 0, 1 in columns 23-26.
  std::string gromacs = line("9999 ", 0) + line("   0 ", 3) + line("   1 ", 6);
  const Molecule g = formatsRead(gromacs, "x.pdb", {.waters = true});
  REQUIRE(g.residues.size() == 3);
  CHECK(g.residues[1].number == 10'000);
  CHECK(g.residues[2].number == 10'001);
  // VMD and others: 10000 in columns 23-27.
  const Molecule v = formatsRead(line("9999 ", 0) + line("10000", 3) + line("10001", 6), "x.pdb", {.waters = true});
  REQUIRE(v.residues.size() == 3);
  CHECK(v.residues[1].number == 10'000);
  CHECK(v.residues[2].number == 10'001);
  CHECK(v.residues[2].insertion == ' ');
}

TEST_CASE("a lipid's name of four letters is whole, and the chain is what follows it") {
  const Molecule m =
      formatsRead("ATOM      1  P   POPCA   7       0.000   0.000   0.000  1.00 12.50           P\n", "x.pdb");
  REQUIRE(m.residues.size() == 1);
  CHECK(m.residues[0].name == "POPC");
  CHECK(m.chains[0].name == "A");
  CHECK(m.atoms[0].b_factor_A2 == 12.5f);
}

TEST_CASE("an assembly of 1680 operators keeps its atoms where they belong, though the columns shift from 1000 on") {
  std::string text =
      "REMARK 350 BIOMOLECULE: 1                                                       \n"
      "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A                                     \n";
  // Turns of a quarter round z, each copy 3 A farther along z.
  const double turns[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int k = 1; k <= 1680; ++k) {
    const double c = turns[k % 4][0], s = turns[k % 4][1];
    const double rows[3][4] = {{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 3.0 * (k - 1)}};
    for (int row = 0; row < 3; ++row) {
      char line[128];
      std::snprintf(line, sizeof line, "REMARK 350   BIOMT%d %3d%10.6f%10.6f%10.6f %14.5f\n", row + 1, k, rows[row][0],
                    rows[row][1], rows[row][2], rows[row][3]);
      text += line;
    }
  }
  text += atomLine(" CA", ' ', "ALA", 'A', 1, ' ', 10, 0, 0, 1, "C") + "END\n";
  const Molecule m = formatsRead(text, "x.pdb", {.assembly = "1"});
  REQUIRE(m.atoms.size() == 1680);
  for (int k = 1; k <= 1680; ++k) {
    const Vec3 at = m.spheres[std::size_t(k - 1)].centre_A;
    CHECK(glm::distance(at, Vec3(10 * turns[k % 4][0], 10 * turns[k % 4][1], 3.0 * (k - 1))) < 1e-4);
  }
}

TEST_CASE("an assembly's operator that is no turn, or not four numbers, is reported instead of applied") {
  const auto with = [](const std::string& row) {
    return "REMARK 350 BIOMOLECULE: 1                                                       \n"
           "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A                                     \n" +
           row +
           "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000            \n"
           "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000            \n" +
           atomLine(" CA", ' ', "ALA", 'A', 1, ' ', 10, 0, 0, 1, "C") + "END\n";
  };
  const std::string wide = with("REMARK 350   BIOMT1   1 12.000000  0.000000  0.000000        0.00000            \n");
  CHECK(problemOf(wide, "x.pdb", {.assembly = "1"}) ==
        "x.pdb: an operator of the assembly '1' is no turn: its rows are not at right angles and of length 1; take the "
        "file again from its source, or read it without an assembly");
  CHECK(problemOf(wide, "x.pdb").empty());
  const std::string none = with("REMARK 350   BIOMT1   1  1.000000  0.0x0000  0.000000        0.00000            \n");
  CHECK(problemOf(none, "x.pdb", {.assembly = "1"}) ==
        "x.pdb:3:14: the assembly's operator is not four numbers after its own: a row of a matrix and a shift; correct "
        "the "
        "line, take the mmCIF file, or read it without an assembly");
  CHECK(problemOf(none, "x.pdb").empty());
}
