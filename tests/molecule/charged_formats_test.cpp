// MOL2 and PDBQT: texts written by hand, and files that Open Babel writes (Debian's package openbabel).
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <numeric>

#include "engine/molecule/elements.h"
#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

Molecule read(const std::string& text, const std::string& name, const ReadOptions& options = {}) {
  auto molecule = readMoleculeBytes(text, name, options);
  if (!molecule) FAIL(molecule.problem().text());
  return *std::move(molecule);
}

std::string seed(const std::string& name) {
  return contentOf(std::filesystem::path(MOLTACT_SOURCE_DIR) / "tests/fuzz/seeds" / name);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

double sum_e(const Molecule& m) { return std::accumulate(m.charges_e.begin(), m.charges_e.end(), 0.0); }

constexpr const char* kObabel = "/usr/bin/obabel";

bool noObabel() {
  if (std::filesystem::exists(kObabel)) return false;
  MESSAGE("did not run: Debian's package openbabel is not installed");
  return true;
}

// The text of the file that Open Babel makes of another.
std::string converted(const std::filesystem::path& from, const std::string& ending, const std::string& options = {}) {
  const Scratch scratch;
  const auto to = scratch.folder / ("out." + ending);
  const std::string command =
      std::string(kObabel) + " '" + from.string() + "' -O '" + to.string() + "' " + options + " >/dev/null 2>&1";
  REQUIRE(std::system(command.c_str()) == 0);
  return contentOf(to);
}

}  // namespace

TEST_CASE(
    "MOL2 gives atoms, types' elements, charges, bonds, residues and chains; lone pairs and waters are left out") {
  const std::string text = seed("mol2/two.mol2");
  const Molecule m = read(text, "x.mol2");
  CHECK(m.title == "methanol and water");
  REQUIRE(m.atoms.size() == 2);
  CHECK(m.atoms[1].nameText() == "O1");
  CHECK(m.atoms[0].atomic_number == 6);
  CHECK(m.atoms[1].atomic_number == 8);
  CHECK(m.spheres[1].centre_A == Vec3(1.4, 0, 0));
  CHECK(m.charges_e.copy() == std::vector<float>{0.1f, -0.6f});
  CHECK(m.listed_bonds.copy() == std::vector<Bond>{{0, 1, BondOrder::Single}});
  REQUIRE(m.residues.size() == 1);
  CHECK(m.residues[0].name == "MOH");
  CHECK(m.residues[0].number == 1);
  CHECK(m.residues[0].kind == ResidueKind::Ligand);
  CHECK(m.chains[0].name == "B");
  CHECK(m.warnings.copy() == std::vector<std::string>{"The file has 2 models; this is model 1.",
                                                      "1 water molecule left out.", "1 lone pair or dummy left out."});
  const Molecule all = read(text, "x.mol2", {.waters = true});
  REQUIRE(all.atoms.size() == 3);
  CHECK(all.residues[1].number == 2);
  CHECK(all.chains[1].name == "A");
  CHECK(all.charges_e[2] == -0.834f);
}

TEST_CASE("a MOL2 file without charges has none, a continued line is one, and bond types are bond orders") {
  const std::string text = seed("mol2/two.mol2");
  const Molecule m = read(text, "no-ending", {.model = 2});
  CHECK(m.charges_e.empty());
  CHECK(m.id == "no-ending");
  CHECK(m.residues[0].name == "UNL");
  CHECK(m.listed_bonds.copy() == std::vector<Bond>{{0, 1, BondOrder::Aromatic}});
  for (const auto& [type, order] : {std::pair("1", BondOrder::Single),
                                    {"am", BondOrder::Single},
                                    {"2", BondOrder::Double},
                                    {"3", BondOrder::Triple},
                                    {"un", BondOrder::Unknown}})
    CHECK(
        read(replaced(text, "1 1 2 ar", "1 1 2 " + std::string(type)), "x.mol2", {.model = 2}).listed_bonds[0].order ==
        order);
  CHECK(read(replaced(text, "1 1 2 ar", "1 1 2 nc"), "x.mol2", {.model = 2}).listed_bonds.empty());
  const std::string zero = "@<TRIPOS>MOLECULE\nx\n1 0\nSMALL\nGASTEIGER\n@<TRIPOS>ATOM\n1 C 0 0 0 C.3 1 A1 0.0\n";
  const Molecule none = read(zero, "x.mol2");
  CHECK(none.charges_e.empty());
  CHECK(none.warnings.copy() ==
        std::vector<std::string>{"All charges of the file are 0; it is read as a file without charges."});
}

TEST_CASE("errors in a MOL2 file are reported at their place") {
  const std::string text = seed("mol2/two.mol2");
  const auto with = [&](const std::string& from, const std::string& to) {
    return problemOf(replaced(text, from, to), "x.mol2");
  };
  const std::string again =
      "; write the file anew with the program that made it; an atom is number, name, x, y, z, type, and where they are "
      "known substructure number, its name and charge";
  CHECK(with("   -0.6000\n", "   minus\n") == "x.mol2:9:64: expected a number for the charge, found 'minus'" + again);
  CHECK(with("   -0.6000\n", "   nan\n") == "x.mol2:9:64: expected a number for the charge, found 'nan'" + again);
  CHECK(with("   -0.6000\n", "   100.5\n") == "x.mol2:9:64: the charge '100.5' is not from -100 to 100" + again);
  CHECK(with("        0.1000\n", "\n") ==
        "x.mol2:8:57: the atom has no charge, although the molecule's fourth line names charges" + again);
  CHECK(with("1.4000", "1,4000") == "x.mol2:9:15: expected a number for x, found '1,4000'" + again);
  CHECK(with("      2 O1", "      1 O1") == "x.mol2:9:7: two atoms have the number 1" + again);
  CHECK(with("      2 O1", "      b O1") == "x.mol2:9:7: the atom's number is not a number: 'b'" + again);
  CHECK(with(" 4 2 2 0 0", " x") ==
        "x.mol2:3:1: the second line of a molecule starts with the numbers of its atoms and bonds; this is ' x'" +
            again);
  CHECK(with(" 4 2 2 0 0", " 5 2") ==
        "x.mol2:12: the molecule is to have 5 atoms by its second line, and it has 4; copy or download it again");
  CHECK(with(" 4 2 2 0 0", " 4 3") ==
        "x.mol2:15: the molecule is to have 3 bonds by its second line, and it has 2; copy or download it again");
  CHECK(with("1     2    1\n", "1     7    1\n") ==
        "x.mol2:13:18: a bond names the atom 7, which is not there" + again);
  CHECK(with("1     2    1\n", "1     1    1\n") == "x.mol2:13:12: the atom 1 is bonded to itself" + again);
  CHECK(with("1     2    1\n", "1     2    6\n") ==
        "x.mol2:13:23: the bond's type '6' is none of 1, 2, 3, am, ar, du, un, nc" + again);
  CHECK(problemOf("nothing\n", "x.mol2") == "x.mol2: there is no @<TRIPOS>MOLECULE line in it" + again);
  CHECK(problemOf(text, "x.mol2", {.model = 3}).starts_with("x.mol2: there is no model 3; the file has 2 models"));
  // A file cut anywhere before its end gives a message or the first molecule, never a part of one.
  for (std::size_t length = 0; length < text.size(); ++length) {
    const auto cut = readMoleculeBytes(text.substr(0, length), "x.mol2", {.waters = true});
    if (cut) CHECK(cut->atoms.size() == 3);
  }
}

TEST_CASE("PDBQT gives atoms, types' elements and charges; ROOT and BRANCH are ignored, MODEL is a model") {
  const std::string text = seed("pdbqt/two.pdbqt");
  const Molecule m = read(text, "x.pdbqt");
  REQUIRE(m.atoms.size() == 3);
  CHECK(m.atoms[0].atomic_number == 6);
  CHECK(m.atoms[1].atomic_number == 8);
  CHECK(m.atoms[2].atomic_number == 1);
  CHECK(m.charges_e.copy() == std::vector<float>{0.12f, -0.35f, 0.21f});
  CHECK(m.spheres[1].centre_A == Vec3(3.166, -1.08, -0.423));
  CHECK(m.atoms[1].b_factor_A2 == 12.0f);
  REQUIRE(m.residues.size() == 1);
  CHECK(m.residues[0].kind == ResidueKind::Ligand);
  CHECK(m.chains[0].name == "A");
  CHECK(m.warnings.copy() ==
        std::vector<std::string>{"The file has 2 models; this is model 1.", "1 point of an opened ring left out."});
  const Molecule second = read(text, "x.pdbqt", {.model = 2});
  CHECK(second.atoms[0].atomic_number == 7);  // NA is a nitrogen
  CHECK(second.residues[0].number == 12);
  CHECK(second.charges_e.empty());
  CHECK(second.warnings[1] == "All charges of the file are 0; it is read as a file without charges.");
}

TEST_CASE(
    "a PDBQT file is recognized under a name that ends in .pdb, .ent or nothing known, and a PDB file under none of "
    "them is taken for one") {
  for (const char* name : {"x.pdb", "x.ent", "x.out", "x"}) {
    CAPTURE(name);
    const Molecule m = read(seed("pdbqt/two.pdbqt"), name);
    CHECK(m.atoms.size() == 3);
    REQUIRE(m.charges_e.size() == 3);
    CHECK(m.charges_e[1] == doctest::Approx(-0.35));
    CHECK(m.atoms[0].atomic_number == 6);
  }
  // A segment name, and a formal charge behind the element.
  const std::string pdb =
      "ATOM      1  N   GLY A   1       1.000   2.000   3.000  1.00 12.50      SEG1 N1+\n"
      "ATOM      2  CA  GLY A   1       2.400   2.000   3.000  1.00 12.50      0.12 C  \n";
  for (const char* name : {"x.pdb", "x"}) {
    const Molecule m = read(pdb, name);
    CHECK(m.atoms.size() == 2);
    CHECK(m.charges_e.empty());
  }
}

TEST_CASE("AutoDock's types are their elements, and an unknown one is reported") {
  const std::string text = seed("pdbqt/two.pdbqt");
  for (const auto& [type, number] :
       {std::pair("C ", 6), {"A ", 6},  {"N ", 7},  {"NA", 7},  {"NS", 7},  {"OA", 8},  {"OS", 8},
        {"SA", 16},         {"S ", 16}, {"HD", 1},  {"H ", 1},  {"F ", 9},  {"Cl", 17}, {"CL", 17},
        {"BR", 35},         {"I ", 53}, {"P ", 15}, {"Zn", 30}, {"MG", 12}, {"Na", 11}, {"CG0", 6},
        {"HN", 1},          {"HS", 1},  {"W ", 8},  {"QQ", 0}}) {
    CAPTURE(type);
    const Molecule m = read(replaced(text, "0.120 A ", "0.120 " + std::string(type)), "x.pdbqt");
    CHECK(int(m.atoms[0].atomic_number) == number);
    CHECK((m.warnings.size() == 3) == (number == 0));
    if (number == 0) CHECK(m.warnings[2].starts_with("No van der Waals radius is known for the element 'QQ' (1 atom)"));
  }
}

TEST_CASE("errors in a PDBQT file are reported at their place") {
  const std::string text = seed("pdbqt/two.pdbqt");
  const auto with = [&](const std::string& from, const std::string& to) {
    return problemOf(replaced(text, from, to), "x.pdbqt");
  };
  const std::string again =
      "; PDBQT has x, y, z in columns 31-54, the charge in 71-76 and the type from 78 on; correct the line, or write "
      "the file anew (obabel, prepare_receptor)";
  CHECK(with("-0.350 OA", "-0.3x0 OA") == "x.pdbqt:5:71: expected a number for the charge, found '-0.3x0'" + again);
  CHECK(with("-0.350 OA", "   inf OA") == "x.pdbqt:5:71: expected a number for the charge, found 'inf'" + again);
  CHECK(with("-0.350 OA", "-1e+09 OA") == "x.pdbqt:5:71: the charge '-1e+09' is not from -100 to 100" + again);
  CHECK(with("-0.350 OA", "       OA") == "x.pdbqt:5:71: expected a number for the charge, found ''" + again);
  CHECK(with("  -0.350 OA", "") == "x.pdbqt:5:69: the atom's line ends before its charge and type do" + again);
  CHECK(with("  -1.080", "  -1,080") == "x.pdbqt:5:39: y is not a number: '  -1,080'" + again);
  CHECK(with("UNL A   1       3", "UNL A   x       3") ==
        "x.pdbqt:5:23: the residue number is not a number: 'x'" + again);
  CHECK(problemOf("REMARK\n", "x.pdbqt") == "x.pdbqt: there is no ATOM or HETATM line in it" + again);
}

TEST_CASE("Open Babel's MOL2 of benzene, amprenavir and ubiquitin has the atoms, places and residues of the PDB file") {
  if (noObabel()) return;
  for (const char* name : {"benzene.pdb", "amprenavir.pdb", "1ubq.pdb"}) {
    CAPTURE(name);
    const auto file = libraryFolder() / name;
    const auto right = readMolecule(file, {.waters = true});
    REQUIRE(right);
    const Molecule m = read(converted(file, "mol2"), "x.mol2", {.waters = true});
    REQUIRE(m.atoms.size() == right->atoms.size());
    CHECK(m.residues.size() == right->residues.size());
    for (std::size_t i = 0; i < m.atoms.size(); ++i) {
      REQUIRE(m.atoms[i].atomic_number == right->atoms[i].atomic_number);
      REQUIRE(glm::distance(m.spheres[i].centre_A, right->spheres[i].centre_A) < 1e-4);
      REQUIRE(m.residues[m.atoms[i].residue].kind == right->residues[right->atoms[i].residue].kind);
    }
    CHECK(m.charges_e.size() == m.atoms.size());
    CHECK(m.listed_bonds.size() + 100 > right->atoms.size());
  }
}

TEST_CASE(
    "charges and places of Open Babel's MOL2 and PDBQT of amprenavir, net charge 0, and of acetate with "
    "methylammonium are those of the PQR files that it makes of them") {
  if (noObabel()) return;
  const Scratch scratch;
  const auto amprenavir = scratch.write("h.mol2", converted(libraryFolder() / "amprenavir.pdb", "mol2", "-h"));
  const auto salt = scratch.write(
      "salt.mol2", converted(scratch.write("salt.smi", "CC(=O)[O-].[NH3+]C\n"), "mol2", "--gen3d --partialcharge eem"));
  for (const auto& mol2 : {amprenavir, salt})
    for (const char* ending : {"mol2", "pdbqt"}) {
      CAPTURE(mol2.string());
      CAPTURE(ending);
      const std::string options = ending == std::string("pdbqt") ? "-xr --partialcharge gasteiger" : "";
      const auto file = scratch.write(std::string("own.") + ending, converted(mol2, ending, options));
      const Molecule m = read(contentOf(file), file.filename().string());
      const Molecule right = read(converted(file, "pqr"), "x.pqr");
      REQUIRE(m.atoms.size() == right.atoms.size());
      REQUIRE(m.charges_e.size() == m.atoms.size());
      CHECK(m.atoms.size() == (mol2 == amprenavir              ? ending == std::string("mol2") ? 70u : 39u
                               : ending == std::string("mol2") ? 15u
                                                               : 9u));
      CHECK(std::abs(sum_e(m)) < 0.02);
      double largest_e = 0.0;
      for (std::size_t i = 0; i < m.atoms.size(); ++i) {
        CHECK(m.atoms[i].atomic_number == right.atoms[i].atomic_number);
        CHECK(glm::distance(m.spheres[i].centre_A, right.spheres[i].centre_A) < 0.001);
        CHECK(std::abs(m.charges_e[i] - right.charges_e[i]) < 1e-4f);
        largest_e = std::max(largest_e, std::abs(double(m.charges_e[i])));
      }
      CHECK(largest_e > 0.2);
    }
}

TEST_CASE(
    "formal charges are kept from columns 79-80 of PDB, _atom_site.pdbx_formal_charge of mmCIF, M  CHG, the atoms' "
    "codes "
    "and CHG= of SDF, and UNITY_ATOM_ATTR of MOL2; a file without any takes no memory for them") {
  const auto charges = [](const std::string& text, const std::string& name, const ReadOptions& options = {}) {
    const Molecule m = read(text, name, options);
    return std::vector<int>(m.formal_charges_e.begin(), m.formal_charges_e.end());
  };
  const std::string atom = "HETATM    1 ZN    ZN A   1       0.000   0.000   0.000  1.00  0.00          ZN";
  const std::string water = "HETATM    2  O   HOH A   2       5.000   0.000   0.000  1.00  0.00           O";
  CHECK(charges(atom + "2+\nEND\n", "x.pdb") == std::vector<int>{2});
  CHECK(charges(atom + "-1\nEND\n", "x.pdb") == std::vector<int>{-1});
  CHECK(charges(atom + "\nEND\n", "x.pdb").empty());
  CHECK(charges(atom + " 7\nEND\n", "x.pdb").empty());
  // A water before the ion is left out, and the charge stays with the ion.
  CHECK(charges(water + "\n" + atom + "2+\nEND\n", "x.pdb") == std::vector<int>{2});
  CHECK(charges(water + "1-\n" + atom + "\nEND\n", "x.pdb").empty());
  // Before 1996 columns 73-80 held the entry's name and the number of the line.
  CHECK(charges("HETATM    1 ZN    ZN A   1       0.000   0.000   0.000  1.00  0.00      1ABC  2+\nEND\n", "x.pdb")
            .empty());
  const std::string head =
      "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
      "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n_atom_site.Cartn_x\n"
      "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_formal_charge\n";
  CHECK(
      charges(head + "HETATM 1 ZN ZN ZN A 1 0 0 0 +2\nHETATM 2 C C1 LIG B 1 5 0 0 ?\nHETATM 3 O O1 LIG B 1 6 0 0 -1\n",
              "x.cif") == std::vector<int>{2, 0, -1});
  const Molecule odd = read(head + "HETATM 1 ZN ZN ZN A 1 0 0 0 much\n", "x.cif");
  CHECK(odd.formal_charges_e.empty());
  REQUIRE(odd.warnings.size() == 1);
  CHECK(odd.warnings[0].find("much") != std::string::npos);
  const std::string v2000 =
      "acetate\n\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n"
      "    0.0000    0.0000    0.0000 C   0  3\n    1.2500    0.0000    0.0000 O   0  5\n  1  2  1\n";
  CHECK(charges(v2000 + "M  END\n$$$$\n", "x.sdf") == std::vector<int>{1, -1});
  CHECK(charges(v2000 + "M  CHG  1   2  -1\nM  END\n$$$$\n", "x.sdf") == std::vector<int>{0, -1});
  CHECK(charges(v2000 + "M  CHG  1   2  -1\n$$$$\n" + v2000 + "M  CHG  2   1   2   2  -2\nM  END\n", "x.sdf",
                {.model = 2}) == std::vector<int>{2, -2});
  CHECK(problemOf(v2000 + "M  CHG  1   3  -1\nM  END\n", "x.sdf").find("names the atom 3") != std::string::npos);
  CHECK(problemOf(v2000 + "M  CHG  2   1  -1\nM  END\n", "x.sdf").find("columns of four") != std::string::npos);
  CHECK(charges("x\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 2 1 0 0 0\n"
                "M  V30 BEGIN ATOM\nM  V30 1 N 0 0 0 0 CHG=1\nM  V30 2 C 1.5 0 0 0\nM  V30 END ATOM\nM  V30 END CTAB\n"
                "M  END\n",
                "x.sdf") == std::vector<int>{1, 0});
  const std::string two = seed("mol2/two.mol2");
  CHECK(charges(two, "x.mol2").empty());
  const std::string attributes = "@<TRIPOS>UNITY_ATOM_ATTR\n1 2\nnote x\ncharge -1\n";
  CHECK(charges(replaced(two, "@<TRIPOS>BOND", attributes + "@<TRIPOS>BOND"), "x.mol2") == std::vector<int>{-1, 0});
  CHECK(problemOf(replaced(two, "@<TRIPOS>BOND", "@<TRIPOS>UNITY_ATOM_ATTR\n1 1\ncharge 0.5\n@<TRIPOS>BOND"), "x.mol2")
            .find("no whole number") != std::string::npos);
}
