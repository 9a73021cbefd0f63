// Lewis structures of molecules whose formulas are known, and the SD files that are made of them: the columns of the
// specification, our reader, and Open Babel (Debian's package openbabel) where it is installed.
#include "engine/structure/lewis_structure.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <map>
#include <numeric>
#include <sstream>

#include "engine/molecule/write_sdf.h"
#include "engine/structure/bonds.h"
#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

Molecule fromText(const std::string& text, const std::string& name) {
  auto molecule = readMoleculeBytes(text, name);
  if (!molecule) FAIL(molecule.problem().text());
  return *std::move(molecule);
}

Molecule fromLibrary(const std::string& name) {
  auto molecule = readMolecule(libraryFolder() / name);
  if (!molecule) FAIL(molecule.problem().text());
  return *std::move(molecule);
}

std::vector<std::uint32_t> atomsOf(const Molecule& m, const std::string& residue) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
    if (residue.empty() || std::string_view(m.residues[m.atoms[i].residue].name) == residue) out.push_back(i);
  return out;
}

std::vector<char> marked(const Molecule& m, const std::vector<std::uint32_t>& atoms) {
  std::vector<char> out(m.atoms.size(), 0);
  for (const std::uint32_t i : atoms) out[i] = 1;
  return out;
}

std::string asSdf(const Molecule& m, const std::vector<std::uint32_t>& atoms, std::span<const SdfItem> items = {}) {
  const LewisStructure lewis = lewisStructure(m, marked(m, atoms));
  std::vector<Vec3> places;
  std::vector<std::int8_t> charges;
  for (const std::uint32_t i : atoms) {
    places.push_back(m.spheres[i].centre_A);
    charges.push_back(lewis.formal_charges_e[i]);
  }
  auto text = posedSdf(m, {atoms, places, charges}, lewis.bonds, "test", "", items);
  REQUIRE(text);
  return *text;
}

int charge_e(const Molecule& m) { return std::accumulate(m.formal_charges_e.begin(), m.formal_charges_e.end(), 0); }

std::map<BondOrder, int> orders(const Molecule& m) {
  std::map<BondOrder, int> out;
  for (const Bond& b : m.listed_bonds) ++out[b.order];
  return out;
}

}  // namespace

TEST_CASE("amprenavir of 1HPV, without hydrogens: 28 single and 9 double bonds and no charge, as its formula has") {
  const Molecule m = fromLibrary("1hpv.pdb");
  const auto atoms = atomsOf(m, "478");
  REQUIRE(atoms.size() == 35);
  const Molecule back = fromText(asSdf(m, atoms), "x.sdf");
  CHECK(orders(back) == std::map<BondOrder, int>{{BondOrder::Single, 28}, {BondOrder::Double, 9}});
  CHECK(charge_e(back) == 0);
}

TEST_CASE(
    "a MOL2 molecule with aromatic bonds: benzoate gets three double bonds in the ring, one C=O and one O with the "
    "charge -1; an ammonium's nitrogen with four bonds gets 1") {
  std::string atoms, bonds;
  const double turn = 2.0 * 3.14159265358979 / 6.0;
  char line[120];
  for (int k = 0; k < 6; ++k) {
    std::snprintf(line, sizeof line, "%d C%d %.4f %.4f 0 C.ar 1 BEZ 0\n", k + 1, k + 1, 1.39 * std::cos(k * turn),
                  1.39 * std::sin(k * turn));
    atoms += line;
    std::snprintf(line, sizeof line, "%d %d %d ar\n", k + 1, k + 1, (k + 1) % 6 + 1);
    bonds += line;
  }
  atoms += "7 C7 2.88 0 0 C.2 1 BEZ 0\n8 O1 3.50 1.08 0 O.co2 1 BEZ 0\n9 O2 3.50 -1.08 0 O.co2 1 BEZ 0\n";
  bonds += "7 1 7 1\n8 7 8 ar\n9 7 9 ar\n";
  const Molecule m = fromText(
      "@<TRIPOS>MOLECULE\nbenzoate\n9 9 1\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n" + atoms + "@<TRIPOS>BOND\n" + bonds,
      "x.mol2");
  const Molecule back = fromText(asSdf(m, atomsOf(m, "")), "x.sdf");
  CHECK(orders(back) == std::map<BondOrder, int>{{BondOrder::Single, 5}, {BondOrder::Double, 4}});
  CHECK(charge_e(back) == -1);
  CHECK(std::count(back.formal_charges_e.begin(), back.formal_charges_e.end(), -1) == 1);
  const Molecule ammonium = fromText(
      "@<TRIPOS>MOLECULE\nx\n5 4 1\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n1 N 0 0 0 N.4\n2 H1 0.6 0.6 0.6 H\n"
      "3 H2 -0.6 -0.6 0.6 H\n4 H3 -0.6 0.6 -0.6 H\n5 H4 0.6 -0.6 -0.6 H\n@<TRIPOS>BOND\n1 1 2 1\n2 1 3 1\n3 1 4 "
      "1\n4 1 5 1\n",
      "y.mol2");
  CHECK(charge_e(fromText(asSdf(ammonium, atomsOf(ammonium, "")), "y.sdf")) == 1);
}

TEST_CASE("ubiquitin as SDF is a V2000 molecule of 602 atoms with the charge 0 of 11 acids and 11 bases") {
  const Molecule m = fromLibrary("1ubq.pdb");
  const std::string text = asSdf(m, atomsOf(m, ""));
  CHECK(text.find("V2000") != std::string::npos);
  const Molecule back = fromText(text, "x.sdf");
  REQUIRE(back.atoms.size() == m.atoms.size());
  CHECK(charge_e(back) == 0);
  CHECK(std::count(back.formal_charges_e.begin(), back.formal_charges_e.end(), -1) == 11);
  CHECK(std::count(back.formal_charges_e.begin(), back.formal_charges_e.end(), 1) == 11);
  const std::vector<Bond> bonds = findBonds(m);
  REQUIRE(back.listed_bonds.size() == bonds.size());
  for (std::size_t k = 0; k < bonds.size(); ++k)
    if (bonds[k].order != BondOrder::Unknown) CHECK(back.listed_bonds[k] == bonds[k]);
}

TEST_CASE("1 516 atoms are written as V3000 and read back: elements, places to 0.00005 A, bonds and charges") {
  const Molecule m = fromLibrary("1hpv.pdb");
  std::vector<std::uint32_t> atoms;
  for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
    if (m.residues[m.atoms[i].residue].kind == ResidueKind::AminoAcid) atoms.push_back(i);
  REQUIRE(atoms.size() == 1516);
  const std::string text = asSdf(m, atoms);
  CHECK(text.find("V3000") != std::string::npos);
  const Molecule back = fromText(text, "x.sdf");
  REQUIRE(back.atoms.size() == atoms.size());
  const LewisStructure lewis = lewisStructure(m, marked(m, atoms));
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    CHECK(back.atoms[k].atomic_number == m.atoms[atoms[k]].atomic_number);
    CHECK(glm::distance(back.spheres[k].centre_A, m.spheres[atoms[k]].centre_A) < 0.0001);
    CHECK(back.formal_charges_e[k] == lewis.formal_charges_e[atoms[k]]);
  }
  CHECK(back.listed_bonds.size() > 1500);
}

TEST_CASE(
    "the lines of a V2000 file have the columns of the specification: x, y, z in 1-30, element in 32-34, bonds in "
    "threes, at most eight charges a line in fours, data items with an empty line behind, $$$$ at the end") {
  const Molecule m = fromLibrary("1ubq.pdb");
  const SdfItem items[] = {{"energy_kcal_per_mol", "-12.345"}};
  const std::string text = asSdf(m, atomsOf(m, ""), items);
  std::istringstream lines(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  const std::size_t atoms = m.atoms.size();
  REQUIRE(all.size() > atoms + 10);
  CHECK(all[1].substr(20, 2) == "3D");
  CHECK(std::stoi(all[3].substr(0, 3)) == int(atoms));
  const auto bonds = std::size_t(std::stoi(all[3].substr(3, 3)));
  CHECK(all[3].substr(33) == " V2000");
  for (std::size_t k = 0; k < atoms; ++k) {
    const std::string& line = all[4 + k];
    REQUIRE(line.size() == 69);
    for (const std::size_t point : {5u, 15u, 25u}) CHECK(line[point] == '.');
    CHECK(line[30] == ' ');
    CHECK(line[31] >= 'A');
    CHECK(line.substr(34, 2) == " 0");
  }
  std::size_t at = 4 + atoms;
  for (std::size_t k = 0; k < bonds; ++k, ++at) REQUIRE(all[at].size() == 21);
  int charges = 0;
  for (; all[at].starts_with("M  CHG"); ++at) {
    const int count = std::stoi(all[at].substr(6, 3));
    CHECK(count <= 8);
    CHECK(all[at].size() == std::size_t(9 + 8 * count));
    charges += count;
  }
  CHECK(charges == 22);
  CHECK(all[at] == "M  END");
  CHECK(all[at + 1] == "> <energy_kcal_per_mol>");
  CHECK(all[at + 2] == "-12.345");
  CHECK(all[at + 3].empty());
  CHECK(all[at + 4] == "$$$$");
  CHECK(all.size() == at + 5);
}

TEST_CASE("a metal's bond makes the file V3000 with type 9; a place beyond the columns is a problem with a remedy") {
  const Molecule m = fromText(
      "x\n\n\n  2  0  0  0  0  0  0  0  0  0999 V2000\n"
      "    0.0000    0.0000    0.0000 Zn  0  0\n    2.1000    0.0000    0.0000 N   0  0\nM  END\n",
      "x.sdf");
  const std::vector<std::uint32_t> atoms = {0, 1};
  std::vector<Vec3> places = {Vec3(0.0), Vec3(2.1, 0.0, 0.0)};
  const Bond bond{0, 1, BondOrder::Coordination};
  const auto text = posedSdf(m, {atoms, places}, {&bond, 1}, "", "", {});
  REQUIRE(text);
  const Molecule back = fromText(*text, "x.sdf");
  REQUIRE(back.listed_bonds.size() == 1);
  CHECK(back.listed_bonds[0].order == BondOrder::Coordination);
  places[1].x = 100000.0;
  const auto far = posedSdf(m, {atoms, places}, {&bond, 1}, "", "", {});
  REQUIRE_FALSE(far);
  CHECK_FALSE(far.problem().remedy.empty());
}

TEST_CASE(
    "Open Babel reads our SD files of amprenavir and ubiquitin: its formula and charge are those of the molecules") {
  if (!std::filesystem::exists("/usr/bin/obabel")) {
    MESSAGE("did not run: Debian's package openbabel is not installed");
    return;
  }
  const auto inchi = [](const std::string& sdf, const std::string& options) {
    const Scratch scratch;
    const auto from = scratch.write("x.sdf", sdf), to = scratch.folder / "out.txt";
    const std::string command =
        "/usr/bin/obabel '" + from.string() + "' " + options + " -O '" + to.string() + "' >/dev/null 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    return contentOf(to);
  };
  const Molecule drug = fromLibrary("1hpv.pdb");
  const std::string formula = inchi(asSdf(drug, atomsOf(drug, "478")), "-otxt --append formula");
  CHECK_MESSAGE(formula.find("C25H35N3O6S") != std::string::npos, formula);
  const Molecule ubiquitin = fromLibrary("1ubq.pdb");
  // 1UBQ ends in a carboxylate and begins with an amine without charges here: C378 H629 N105 O118 S with neutral ends.
  const std::string whole = inchi(asSdf(ubiquitin, atomsOf(ubiquitin, "")), "-otxt --append formula");
  CHECK_MESSAGE(whole.find("C378H629N105O118S") != std::string::npos, whole);
}
