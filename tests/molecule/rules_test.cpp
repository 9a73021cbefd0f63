// The reader's rules with small files: alternate locations, models, waters, insertion codes, assemblies, elements.
#include <doctest/doctest.h>

#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

Molecule rulesRead(const std::string& text, const std::string& name = "x.pdb", const ReadOptions& options = {}) {
  auto molecule = readMoleculeBytes(text, name, options);
  if (!molecule) FAIL(molecule.problem().text());
  return *std::move(molecule);
}

std::vector<double> xs(const Molecule& m) {
  std::vector<double> out;
  for (const Sphere& atom : m.spheres) out.push_back(atom.centre_A.x);
  return out;
}

const std::string kRulesCifHead =
    "data_TEST\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_"
    "id\n"
    "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.auth_seq_id\n"
    "_atom_site.pdbx_PDB_ins_code\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site."
    "occupancy\n"
    "_atom_site.pdbx_PDB_model_num\n_atom_site.auth_asym_id\n";

}  // namespace

TEST_CASE("of alternate atoms the more occupied is kept, the first on a tie; order and the others stay") {
  const std::string text = atomLine(" N", ' ', "SER", 'A', 5, ' ', 0, 0, 0, 1.0, "N") +
                           atomLine(" CA", 'A', "SER", 'A', 5, ' ', 1, 0, 0, 0.3, "C") +
                           atomLine(" CA", 'B', "SER", 'A', 5, ' ', 2, 0, 0, 0.7, "C") +
                           atomLine(" CB", 'A', "SER", 'A', 5, ' ', 3, 0, 0, 0.5, "C") +
                           atomLine(" CB", 'B', "SER", 'A', 5, ' ', 4, 0, 0, 0.5, "C") +
                           atomLine(" OG", 'C', "SER", 'A', 5, ' ', 5, 0, 0, 0.2, "O") + "END\n";
  const Molecule m = rulesRead(text);
  CHECK(xs(m) == std::vector<double>{0, 2, 3, 5});
  CHECK(m.alternates_left_out == 2);
  CHECK(m.warnings == std::vector<std::string>{"2 atoms at a less occupied alternate location left out."});
}

TEST_CASE("where the alternatives are Ser 0.4 and Thr 0.6, line by line in turn, Thr is kept whole") {
  std::string text;
  int x = 0;
  for (const char* name : {" N", " CA", " C"}) {
    text += atomLine(name, 'A', "SER", 'A', 5, ' ', x++, 0, 0, 0.4, "C");
    text += atomLine(name, 'B', "THR", 'A', 5, ' ', x++, 0, 0, 0.6, "C");
  }
  const Molecule m = rulesRead(text);
  CHECK(xs(m) == std::vector<double>{1, 3, 5});
  REQUIRE(m.residues.size() == 1);
  CHECK(m.residues[0].name == "THR");
}

TEST_CASE("an atom's name used twice without alternate locations is kept twice") {
  const std::string line = atomLine(" C", ' ', "LIG", 'A', 1, ' ', 0, 0, 0, 1, "C", "HETATM");
  CHECK(rulesRead(line + line).atoms.size() == 2);
}

TEST_CASE("the first of three models is read unless another is asked for, by place in the file") {
  std::string text;
  for (int model : {4, 7, 9})
    text += "MODEL     " + std::to_string(model) + "\n" + atomLine(" N", ' ', "GLY", 'A', 1, ' ', model, 0, 0, 1, "N") +
            "ENDMDL\n";
  CHECK(xs(rulesRead(text)) == std::vector<double>{4});
  CHECK(xs(rulesRead(text, "x.pdb", {.model = 3})) == std::vector<double>{9});
  CHECK(rulesRead(text).warnings == std::vector<std::string>{"The file has 3 models; this is model 1."});
  CHECK(problemOf(text, "x.pdb", {.model = 4}) ==
        "x.pdb: there is no model 4; the file has 3 models; ask for a model from 1 to 3");
  CHECK(problemOf(text, "x.pdb", {.model = 0}) ==
        "x.pdb: there is no model 0; the file has 3 models; ask for a model from 1 to 3");
}

TEST_CASE("mmCIF's models, alternates and insertion codes follow the same rules") {
  const std::string text = kRulesCifHead +
                           "ATOM 1 N N . GLY A 52 A 1 0 0 1.0 1 H\n"
                           "ATOM 2 C CA A GLY A 52 A 2 0 0 0.4 1 H\nATOM 3 C CA B GLY A 52 A 3.5(2) 0 0 0.6 1 H\n"
                           "HETATM 4 O O . HOH B 60 ? 4 0 0 1.0 1 H\nATOM 5 N N . GLY A 52 A 5 0 0 1.0 2 H\n";
  const Molecule m = rulesRead(text, "x.cif");
  CHECK(xs(m) == std::vector<double>{1, 3.5});
  CHECK(m.describe(1) == "CA of Gly 52A (chain H)");
  CHECK(m.waters_left_out == 1);
  CHECK(m.models_in_file == 2);
  CHECK(xs(rulesRead(text, "x.cif", {.model = 2})) == std::vector<double>{5});
}

TEST_CASE("residues 52, 52A and 52B are three") {
  std::string text;
  for (char code : {' ', 'A', 'B'}) text += atomLine(" CA", ' ', "SER", 'H', 52, code, 0, 0, 0, 1, "C");
  const Molecule m = rulesRead(text);
  REQUIRE(m.residues.size() == 3);
  CHECK(m.residues[2].insertion == 'B');
  CHECK(m.describe(0) == "CA of Ser 52 (chain H)");
}

TEST_CASE("waters between two ligands are left out unless asked for, and the order of the rest stays") {
  const std::string text = atomLine("ZN", ' ', " ZN", 'A', 1, ' ', 1, 0, 0, 1, "ZN", "HETATM") +
                           atomLine(" O", ' ', "HOH", 'A', 2, ' ', 2, 0, 0, 1, "O", "HETATM") +
                           atomLine(" O", ' ', "DOD", 'A', 3, ' ', 3, 0, 0, 1, "O", "HETATM") +
                           atomLine("CL", ' ', " CL", 'A', 4, ' ', 4, 0, 0, 1, "CL", "HETATM");
  const Molecule m = rulesRead(text);
  CHECK(xs(m) == std::vector<double>{1, 4});
  CHECK(m.waters_left_out == 2);
  CHECK(m.residues[0].kind == ResidueKind::Ion);
  CHECK(m.atoms[0].atomic_number == 30);
  CHECK(xs(rulesRead(text, "x.pdb", {.waters = true})) == std::vector<double>{1, 2, 3, 4});
}

TEST_CASE("hydrogens are kept, deuterium counts as hydrogen") {
  const Molecule m = rulesRead(atomLine(" HA", ' ', "GLY", 'A', 1, ' ', 0, 0, 0, 1, "H") +
                               atomLine(" DA", ' ', "GLY", 'A', 1, ' ', 1, 0, 0, 1, "D"));
  CHECK(m.atoms[0].atomic_number == 1);
  CHECK(m.atoms[1].atomic_number == 1);
  CHECK(m.spheres[1].radius_A == 1.20);
}

TEST_CASE("two unknown elements in three atoms give 1.70 A and two warnings") {
  const std::string text = kRulesCifHead +
                           "HETATM 1 Qq Q1 . LIG A 1 ? 0 0 0 1 1 A\nHETATM 2 Qq Q2 . LIG A 1 ? 4 0 0 1 1 "
                           "A\nHETATM 3 Xy X1 . LIG A 1 ? 8 0 0 1 1 A\n";
  const Molecule m = rulesRead(text, "x.cif");
  CHECK(m.warnings == std::vector<std::string>{
                          "No van der Waals radius is known for the element 'Qq' (2 atoms); 1.70\u00a0Å was taken.",
                          "No van der Waals radius is known for the element 'Xy' (1 atom); 1.70\u00a0Å was taken."});
  for (const Sphere& atom : m.spheres) CHECK(atom.radius_A == 1.70);
}

TEST_CASE(
    "an old PDB line without element columns gives the element by the name: CA carbon, FE iron, HG11 "
    "hydrogen") {
  const auto cut = [](std::string line) { return line.substr(0, 66) + "      2HHB 206\n"; };
  const Molecule m = rulesRead(cut(atomLine(" CA", ' ', "VAL", 'A', 1, ' ', 0, 0, 0, 1, "")) +
                               cut(atomLine("HG11", ' ', "VAL", 'A', 1, ' ', 0, 0, 0, 1, "")) +
                               cut(atomLine("FE", ' ', "HEM", 'A', 142, ' ', 0, 0, 0, 1, "", "HETATM")));
  CHECK(m.atoms[0].atomic_number == 6);
  CHECK(m.atoms[1].atomic_number == 1);
  CHECK(m.atoms[2].atomic_number == 26);
}

TEST_CASE("a PDB assembly of a half turn gives chains A and A-2; an atom on the axis is there once") {
  std::string text =
      "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
      "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
      "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000       10.00000\n"
      "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n";
  text += atomLine(" N", ' ', "GLY", 'A', 1, ' ', 1, 2, 3, 1, "N") +
          atomLine("ZN", ' ', " ZN", 'A', 2, ' ', 5, 0, 7, 1, "ZN", "HETATM");
  CHECK(rulesRead(text).atoms.size() == 2);
  const Molecule m = rulesRead(text, "x.pdb", {.assembly = "1"});
  REQUIRE(m.atoms.size() == 3);
  CHECK(m.spheres[2].centre_A == Vec3(9, -2, 3));
  REQUIRE(m.chains.size() == 2);
  CHECK(m.chains[1].name == "A-2");
  CHECK(problemOf(text, "x.pdb", {.assembly = "2"}) ==
        "x.pdb: there is no biological assembly '2'; the file describes: 1");
}

TEST_CASE("an mmCIF assembly with the product (1-2)(P) applies P first, and only to the chains it names") {
  std::string text = kRulesCifHead +
                     "ATOM 1 N N . GLY A 1 ? 1 2 3 1 1 X\nATOM 2 N N . GLY B 1 ? 0 0 0 1 1 Y\n#\n"
                     "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
                     "_pdbx_struct_assembly_gen.asym_id_list\n1 '(1-2)(P)' A\nloop_\n_pdbx_struct_oper_list.id\n";
  for (const char* kind : {"1", "2", "3"})
    for (const char* column : {"1", "2", "3"})
      text += std::string("_pdbx_struct_oper_list.matrix[") + kind + "][" + column + "]\n";
  for (const char* kind : {"1", "2", "3"}) text += std::string("_pdbx_struct_oper_list.vector[") + kind + "]\n";
  // 1: identity; 2: a quarter turn about z; P: 10 A along x
  text += "1 1 0 0 0 1 0 0 0 1 0 0 0\n2 0 -1 0 1 0 0 0 0 1 0 0 0\nP 1 0 0 0 1 0 0 0 1 10 0 0\n";
  const Molecule m = rulesRead(text, "x.cif", {.assembly = "1"});
  REQUIRE(m.atoms.size() == 2);
  CHECK(m.spheres[0].centre_A == Vec3(11, 2, 3));
  CHECK(m.spheres[1].centre_A == Vec3(-2, 11, 3));
  CHECK(m.chains[1].name == "X-2");
}

TEST_CASE("an .xyzr file gives its spheres as they stand: comments, blank lines, signs and exponents are read") {
  const Molecule m = rulesRead("# a comment\n\n 1 2.5 -3 1.2\r\n+4\t5e0 6 0 # the rest\n", "balls.xyzr");
  REQUIRE(m.atoms.size() == 2);
  CHECK(m.id == "balls");
  CHECK(m.spheres[0].centre_A == Vec3(1, 2.5, -3));
  CHECK(m.spheres[0].radius_A == 1.2);
  CHECK(m.spheres[1].radius_A == 0);
  CHECK(m.warnings.empty());
  CHECK(m.describe(1) == "atom 1");
  CHECK(rulesRead("0 0 0 1 CA\n", "n.xyzr").warnings ==
        std::vector<std::string>{"What follows the fourth number of a line was passed over (first on line 1)."});
}

TEST_CASE("each format is also read gzipped, in two members, and by content where the name says nothing") {
  const std::string pdb = atomLine(" N", ' ', "GLY", 'A', 1, ' ', 1, 0, 0, 1, "N");
  CHECK(rulesRead(gzipped(pdb), "x.pdb.gz").atoms.size() == 1);
  CHECK(rulesRead(gzipped(pdb) + gzipped(pdb), "x.ent.gz").atoms.size() == 2);
  CHECK(rulesRead(gzipped("0 0 0 1\n"), "x.xyzr.gz").atoms.size() == 1);
  CHECK(rulesRead(kRulesCifHead + "ATOM 1 N N . GLY A 1 ? 1 2 3 1 1 X\n", "download").atoms.size() == 1);
  CHECK(rulesRead(pdb, "download").atoms.size() == 1);
  CHECK(rulesRead("1 2 3 1.5\n", "spheres.txt").atoms.size() == 1);
}
