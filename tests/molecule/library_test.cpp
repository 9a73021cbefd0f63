// The library's files against manual counts of the PDB records, and the generated ones against geometry.
#include <doctest/doctest.h>

#include <map>
#include <numbers>
#include <tuple>

#include "engine/molecule/catalogue.h"
#include "engine/molecule/summary.h"
#include "molecules/generator/made_molecules.h"
#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

Molecule library(const char* file, const ReadOptions& options = {}) {
  auto molecule = readMolecule(libraryFolder() / file, options);
  REQUIRE_MESSAGE(molecule, file);
  return *std::move(molecule);
}

Vec3 place(const Molecule& m, const char* chain, int number, std::string_view name) {
  for (const Residue& r : m.residues)
    if (r.number == number && m.chains[r.chain].name == chain)
      for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i)
        if (name == m.atoms[i].name.data()) return m.spheres[i].centre_A;
  FAIL("no atom " << name << " in " << chain << number);
  return {};
}

double between(const Molecule& m, const char* chain, int one, const char* name, int other, const char* other_name,
               const char* other_chain = nullptr) {
  return glm::distance(place(m, chain, one, name), place(m, other_chain ? other_chain : chain, other, other_name));
}

double angle_deg(Vec3 a, Vec3 corner, Vec3 b) {
  return std::acos(glm::dot(glm::normalize(a - corner), glm::normalize(b - corner))) * 180 / std::numbers::pi;
}

/// The smallest distance between atoms of residues that are not neighbours in one chain.
double closestFar(const Molecule& m) {
  double least = 1e9;
  for (std::size_t i = 0; i < m.atoms.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Residue &a = m.residues[m.atoms[i].residue], &b = m.residues[m.atoms[j].residue];
      if (a.chain == b.chain && std::abs(a.number - b.number) <= 1) continue;
      least = std::min(least, glm::distance(m.spheres[i].centre_A, m.spheres[j].centre_A));
    }
  return least;
}

}  // namespace

TEST_CASE("every file of the catalogue is read, with the number of atoms that the catalogue gives") {
  const auto entries = readCatalogue(libraryFolder());
  REQUIRE(entries);
  CHECK(entries->size() >= 10);
  for (const CatalogueEntry& e : *entries) {
    CAPTURE(e.id);
    const Molecule molecule = library(e.file.c_str());
    CHECK(molecule.atoms.size() == e.atoms);
    for (const std::string& warning : molecule.warnings) CHECK(warning.find("cut short") == std::string::npos);
    CHECK_FALSE(e.title.empty());
    CHECK_FALSE(e.good_for.empty());
    CHECK_FALSE(e.source.empty());
    CHECK((e.licence == "MIT" || e.licence == "CC0-1.0"));
  }
}

TEST_CASE("1ubq has 602 atoms in 76 residues of one chain, and 58 waters that are left out") {
  const MoleculeSummary s = summarise(library("1ubq.pdb"));
  CHECK(s.atoms == 602);
  CHECK(s.residues == 76);
  CHECK(s.chain_names == std::vector<std::string>{"A"});
  CHECK(s.elements == std::map<std::string, std::size_t>{{"C", 378}, {"N", 105}, {"O", 118}, {"S", 1}});
  CHECK(s.ligands.empty());
  CHECK(s.waters_left_out == 58);
  CHECK(library("1ubq.pdb", {.waters = true}).atoms.size() == 660);
}

TEST_CASE("2hhb has 4384 atoms of protein, four haems of 43 atoms and two phosphate atoms; iron is iron") {
  const Molecule m = library("2hhb.pdb");
  const MoleculeSummary s = summarise(m);
  CHECK(s.atoms == 4384 + 4 * 43 + 2);
  CHECK(s.ligands == std::map<std::string, std::size_t>{{"HEM", 4}, {"PO4", 2}});
  CHECK(s.elements.at("Fe") == 4);
  CHECK(s.waters_left_out == 221);
  for (std::size_t i = 0; i < m.atoms.size(); ++i)
    if (m.atoms[i].atomic_number == 26) {
      CHECK(m.spheres[i].radius_A == 2.44);
      CHECK(m.describe(i) == "FE of haem 1 (chain A)");
      break;
    }
}

TEST_CASE(
    "the haem pockets are atoms of 2hhb, turned: every distance between two atoms is as in the entry to 0.002 A") {
  const Molecule whole = library("2hhb.pdb");
  for (const auto& [file, chain, proximal] :
       {std::tuple{"haem-alpha.pdb", "A", 87}, std::tuple{"haem-beta.pdb", "B", 92}}) {
    CAPTURE(file);
    const Molecule pocket = library(file);
    CHECK(pocket.atoms.size() == 43 + 11 + 10 + 7 + 10);
    std::vector<Vec3> here, there;
    for (const Residue& r : pocket.residues)
      for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) {
        here.push_back(pocket.spheres[i].centre_A);
        there.push_back(place(whole, chain, r.number, pocket.atoms[i].name.data()));
      }
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        CHECK(std::abs(glm::distance(here[i], here[j]) - glm::distance(there[i], there[j])) < 0.002);
    CHECK(between(pocket, chain, 1, "FE", proximal, "NE2") == doctest::Approx(2.146).epsilon(0.002));
    // The iron lies at the origin, the proximal histidine below it, 30 degrees away from straight down.
    CHECK(glm::length(place(pocket, chain, 1, "FE")) < 1e-9);
    const Vec3 down = glm::normalize(place(pocket, chain, proximal, "NE2"));
    CHECK(glm::dot(down, Vec3(0, -std::sqrt(0.75), -0.5)) > 0.98);
  }
}

TEST_CASE("1hpv has 1516 atoms of protein and the 35 of its inhibitor, residue 478") {
  const MoleculeSummary s = summarise(library("1hpv.pdb"));
  CHECK(s.atoms == 1551);
  CHECK(s.ligands == std::map<std::string, std::size_t>{{"478", 1}});
}

TEST_CASE("1hel has 1001 atoms in 129 residues; its Asp 52 is spoken of as such") {
  const Molecule m = library("1hel.pdb");
  CHECK(m.atoms.size() == 1001);
  CHECK(m.residues.size() == 129);
  const Residue& asp = m.residues[51];
  CHECK(asp.kind == ResidueKind::AminoAcid);
  CHECK(m.describe(asp.first_atom + 3) == "O of Asp 52 (chain A)");
}

TEST_CASE("the committed files are what the generator makes, byte for byte") {
  using namespace moltact::generator;
  const std::string entry = contentOf(libraryFolder() / "2hhb.pdb"), protease = contentOf(libraryFolder() / "1hpv.pdb");
  const std::vector<MadeMolecule> made = madeMolecules(entry, protease);
  CHECK(made.size() >= 19);
  for (const auto& [file, text] : made) CHECK_MESSAGE(contentOf(libraryFolder() / file) == text, file);
}

TEST_CASE("water has O-H 0.957 A and H-O-H 104.5 degrees; as the whole file it is not left out") {
  const Molecule m = library("water.pdb");
  REQUIRE(m.atoms.size() == 3);
  const Vec3 o = m.spheres[0].centre_A, h1 = m.spheres[1].centre_A, h2 = m.spheres[2].centre_A;
  CHECK(glm::distance(o, h1) == doctest::Approx(0.957).epsilon(0.001));
  CHECK(angle_deg(h1, o, h2) == doctest::Approx(104.52).epsilon(0.001));
}

TEST_CASE("benzene's six C-C bonds are 1.397 A, its C-H bonds 1.084 A") {
  const Molecule m = library("benzene.pdb");
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(std::abs(glm::distance(m.spheres[i].centre_A, m.spheres[(i + 1) % 6].centre_A) - 1.397) < 0.0015);
    CHECK(std::abs(glm::distance(m.spheres[i].centre_A, m.spheres[i + 6].centre_A) - 1.084) < 0.0015);
  }
}

TEST_CASE(
    "the alpha-helix rises 1.50 A and turns 99.6 degrees a residue, right-handed, with N...O 2.88 A and L "
    "residues") {
  const Molecule m = library("alpha-helix.pdb");
  for (int i = 1; i < 20; ++i) {
    const Vec3 a = place(m, "A", i, "CA"), b = place(m, "A", i + 1, "CA");
    CHECK(std::abs(b.z - a.z - 1.50) < 0.01);
    double turn = (std::atan2(b.y, b.x) - std::atan2(a.y, a.x)) * 180 / std::numbers::pi;
    if (turn < 0) turn += 360;
    CHECK(std::abs(turn - 99.6) < 0.5);
    CHECK(std::abs(glm::length(a - b) - 3.80) < 0.02);
    CHECK(std::abs(between(m, "A", i, "C", i + 1, "N") - 1.329) < 0.002);
  }
  for (int i = 1; i <= 16; ++i) CHECK(std::abs(between(m, "A", i, "O", i + 4, "N") - 2.88) < 0.02);
  for (int i = 1; i <= 20; ++i) {
    const Vec3 ca = place(m, "A", i, "CA"), n = place(m, "A", i, "N") - ca, c = place(m, "A", i, "C") - ca,
               cb = place(m, "A", i, "CB") - ca;
    CHECK(glm::dot(glm::cross(n, c), cb) > 2.0);  // +2.63 in ubiquitin's residue 5
  }
  CHECK(closestFar(m) > 2.8);
}

TEST_CASE(
    "the B-DNA has standard bonds within 0.04 A, 3.38 A and 36 degrees a step, Watson-Crick pairs and a 11.7 "
    "A minor groove") {
  const Molecule m = library("b-dna.pdb");
  // Standard lengths: A. Gelbin et al. (1996) and G. Parkinson et al. (1996).
  const struct {
    const char *a, *b;
    double length;
  } bonds[] = {{"P", "OP1", 1.485},   {"P", "OP2", 1.485},   {"P", "O5'", 1.593},   {"O5'", "C5'", 1.420},
               {"C5'", "C4'", 1.511}, {"C4'", "C3'", 1.528}, {"C3'", "C2'", 1.518}, {"C2'", "C1'", 1.521},
               {"C1'", "O4'", 1.420}, {"O4'", "C4'", 1.446}, {"C3'", "O3'", 1.431}};
  for (const char* chain : {"A", "B"})
    for (int i = 2; i <= 12; ++i) {
      for (const auto& bond : bonds) {
        CAPTURE(bond.a);
        CAPTURE(bond.b);
        CHECK(std::abs(between(m, chain, i, bond.a, i, bond.b) - bond.length) < 0.04);
      }
      CHECK(std::abs(between(m, chain, i - 1, "O3'", i, "P") - 1.607) < 0.04);
    }
  for (int i = 2; i < 12; ++i) {
    const Vec3 a = place(m, "A", i, "P"), b = place(m, "A", i + 1, "P");
    CHECK(std::abs(a.z - b.z - 3.38) < 0.002);
    double turn = (std::atan2(a.y, a.x) - std::atan2(b.y, b.x)) * 180 / std::numbers::pi;
    if (turn < 0) turn += 360;
    CHECK(std::abs(turn - 36.0) < 0.05);  // up along the axis and counter-clockwise: right-handed
  }
  CHECK(between(m, "A", 5, "N1", 8, "N3", "B") == doctest::Approx(2.95).epsilon(0.01));  // A-T
  CHECK(between(m, "A", 4, "N1", 9, "N3", "B") == doctest::Approx(2.91).epsilon(0.01));  // G-C
  double minor = 1e9;
  for (int i = 2; i <= 12; ++i)
    for (int j = 2; j <= 12; ++j) minor = std::min(minor, between(m, "A", i, "P", j, "P", "B"));
  CHECK(minor == doctest::Approx(11.7).epsilon(0.01));
  CHECK(closestFar(m) > 2.65);
}

TEST_CASE("a name is found by id in any case, as a fetched entry or as a path; a wrong one gets the nearest id") {
  const Scratch scratch;
  const MoleculeFolders folders{libraryFolder(), scratch.folder};
  REQUIRE(findMolecule(std::string("1UBQ"), folders));
  CHECK(*findMolecule(std::string("1UBQ"), folders) == libraryFolder() / "1ubq.pdb");
  const auto fetched = scratch.write("9XYZ.cif.gz", "");
  REQUIRE(findMolecule(std::string("9xyz"), folders));
  CHECK(*findMolecule(std::string("9xyz"), folders) == fetched);
  const auto path = scratch.write("mine.xyzr", "0 0 0 1\n");
  CHECK(*findMolecule(path.string(), folders) == path);
  CHECK(findMolecule(std::string("benzen"), folders).problem().text() ==
        "benzen: there is no such file, and no molecule of this name in the library; did you mean 'benzene'?");
  CHECK(findMolecule(std::string("5adh"), folders).problem().remedy ==
        "'moltact fetch 5adh' downloads an entry of the PDB");
  CHECK(findMolecule(std::string("1ubq"), {scratch.folder, {}}).problem().message ==
        "the catalogue of molecules cannot be opened");
}

TEST_CASE("a broken catalogue gives a problem: no JSON, a missing field, a file outside the folder, an id twice") {
  const auto problem = [](const std::string& text) {
    const Scratch scratch;
    scratch.write("catalogue.json", text);
    const auto entries = readCatalogue(scratch.folder);
    return entries ? std::string() : entries.problem().message;
  };
  const std::string rest = R"(","title":"t","good_for":"g","source":"s","licence":"MIT","atoms":1})";
  CHECK(problem("{\"molecules\": [").find("the catalogue is not as it should be") == 0);
  CHECK(problem(R"({"molecules":[{"id":"a"}]})").find("key 'file' not found") != std::string::npos);
  CHECK(problem(R"({"molecules":[{"id":"a","file":"../a.pdb)" + rest + "]}") ==
        "the entry 'a' has the file '../a.pdb'");
  const std::string entry = R"({"id":"a","file":"a.pdb)" + rest;
  CHECK(problem("{\"molecules\":[" + entry + ',' + entry + "]}") == "the id 'a' is there twice");
  CHECK(problem("{\"molecules\":[" + entry + "]}").empty());
}
