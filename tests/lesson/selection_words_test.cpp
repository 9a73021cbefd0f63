// The selection words for classes of atoms: compared with counts in molecules of the library; and the messages for
// words of other programs.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "engine/lesson/selection.h"
#include "engine/lesson/selection_node.h"
#include "engine/molecule/reader.h"
#include "engine/structure/accessible_area.h"

using namespace moltact;

namespace {

Molecule library(const char* file, const ReadOptions& options = {}) {
  auto molecule = readMolecule(std::filesystem::path(MOLTACT_SOURCE_DIR) / "molecules" / file, options);
  if (!molecule) FAIL(molecule.problem().text());
  return *std::move(molecule);
}

std::vector<std::uint32_t> select(const Molecule& m, const char* text) {
  const auto s = parseSelection(text);
  if (!s) FAIL(s.problem().text());
  return s->select(m);
}

std::set<int> residues(const Molecule& m, const char* text) {
  std::set<int> out;
  for (const std::uint32_t i : select(m, text)) out.insert(m.residues[m.atoms[i].residue].number);
  return out;
}

std::set<int> numbers(std::initializer_list<std::pair<int, int>> ranges) {
  std::set<int> out;
  for (const auto& [first, last] : ranges)
    for (int n = first; n <= last; ++n) out.insert(n);
  return out;
}

std::string remedy(const char* text) {
  const auto s = parseSelection(text);
  REQUIRE_MESSAGE(!s, text);
  return s.problem().remedy;
}

}  // namespace

TEST_CASE("helix and sheet of ubiquitin are the residues that mkdssp 4.2.2 finds in helices and strands") {
  const Molecule m = library("1ubq.pdb");
  CHECK(residues(m, "helix") == numbers({{23, 34}, {38, 40}, {57, 59}}));
  CHECK(residues(m, "sheet") == numbers({{2, 7}, {12, 16}, {41, 45}, {48, 49}, {66, 71}}));
  CHECK(select(m, "helix and sheet").empty());
}

TEST_CASE("backbone and side chain are together the polymer, and have nothing in common") {
  const Molecule m = library("1ubq.pdb"), dna = library("b-dna.pdb"), haemoglobin = library("2hhb.pdb");
  CHECK(select(m, "backbone").size() == 4 * 76 + 1);  // with OXT
  CHECK(select(m, "backbone or sidechain").size() == m.atoms.size());
  CHECK(select(m, "backbone and sidechain").empty());
  // A nucleotide of B-DNA has 11 atoms of phosphate and sugar, the first of a strand 3 fewer.
  CHECK(select(dna, "backbone").size() == 2 * (12 * 11 - 3));
  CHECK(select(dna, "sidechain and element P").empty());
  CHECK(select(haemoglobin, "backbone or sidechain") == select(haemoglobin, "protein"));
}

TEST_CASE("each amino acid of ubiquitin is hydrophobic, polar or charged, and only one of them") {
  const Molecule m = library("1ubq.pdb");
  const auto hydrophobic = residues(m, "hydrophobic"), polar = residues(m, "polar"), charged = residues(m, "charged");
  CHECK(hydrophobic.size() + polar.size() + charged.size() == 76);
  CHECK(residues(m, "hydrophobic or polar or charged").size() == 76);
  CHECK(residues(m, "charged") == residues(m, "resname ASP GLU LYS ARG"));
  CHECK(hydrophobic.contains(3));  // Ile
  CHECK(polar.contains(68));       // His
}

TEST_CASE("surface is what a probe of 1.4 A can touch: of ubiquitin all residues but those buried whole") {
  const Molecule m = library("1ubq.pdb");
  const auto areas = accessibleAreas_A2(m.spheres);
  std::vector<char> named(m.atoms.size(), 0);
  for (const std::uint32_t i : select(m, "surface")) named[i] = 1;
  for (std::size_t i = 0; i < named.size(); ++i) {
    CAPTURE(i);
    if (areas[i] > 0.6) CHECK(named[i]);
    if (areas[i] == 0.0) CHECK_FALSE(named[i]);
  }
  CHECK_FALSE(residues(m, "surface").contains(3));
  CHECK(residues(m, "surface").contains(48));
}

TEST_CASE("haemoglobin's four haems are found by their class, their irons as metals, and what is bonded to these") {
  const Molecule m = library("2hhb.pdb");
  CHECK(select(m, "heme") == select(m, "resname HEM"));
  CHECK(select(m, "metal") == select(m, "element Fe"));
  CHECK(select(m, "metal").size() == 4);
  const auto bound = select(m, "bonded to metal");
  CHECK(bound.size() == 4 * 5);
  CHECK(select(m, "bonded to (element Fe) and protein").size() == 4);
  CHECK(residues(m, "chain A and protein and bonded to element Fe") == std::set<int>{87});
  CHECK(select(m, "sugar").empty());
  CHECK(parseSelection("sugar")->whyEmpty(m).message == "a sugar is not in 2HHB");
  CHECK(parseSelection("heme")->noun() == "a haem");
  // All atoms of a residue are bonded to one another, so they belong to what is bonded to it.
  const auto around = select(m, "chain A and bonded to (chain A and residue 87)");
  CHECK(std::includes(around.begin(), around.end(), bound.begin(), bound.begin()));
  CHECK(residues(m, "chain A and bonded to (chain A and residue 87)") == std::set<int>{1, 86, 87, 88});
}

TEST_CASE("sugars and what a crystal was grown in are reported from other ligands") {
  std::string text;
  int number = 0;
  for (const char* residue : {"NAG", "SIA", "GOL", "SO4", "HEM", "ATP"})
    for (const char* atom : {"C1", "C2"}) {
      char line[96];
      std::snprintf(line, sizeof line, "HETATM%5d  %s  %s A%4d    %8.3f   0.000   0.000  1.00  0.00           C\n", 1,
                    atom, residue, 1 + number / 2, 3.0 * number);
      text += line;
      ++number;
    }
  const auto m = readMoleculeBytes(text + "END\n", "x.pdb");
  REQUIRE(m);
  CHECK(select(*m, "sugar") == select(*m, "resname NAG SIA"));
  CHECK(select(*m, "buffer") == select(*m, "resname GOL SO4"));
  CHECK(select(*m, "heme") == select(*m, "resname HEM"));
}

TEST_CASE("words of other programs and residues as chemists write them are answered with what was meant") {
  CHECK(remedy("resi 52") == "did you mean 'residue 52'?");
  CHECK(remedy("resi 35+52") == "did you mean 'residue 35 52'?");
  CHECK(remedy("residue 35+52") == "did you mean 'residue 35 52'?");
  CHECK(remedy("chain A and resn HEM") == "did you mean 'resname HEM'?");
  CHECK(remedy("hetatm") == "did you mean 'ligand'?");
  CHECK(remedy("sidechains") == "did you mean 'sidechain'?");
  CHECK(remedy("Glu 35") == "did you mean 'residue 35'?");
  CHECK(remedy("GLU35") == "did you mean 'residue 35'?");
  CHECK(remedy("Glu-35") == "did you mean 'residue 35'?");
  CHECK(remedy("glu") == "did you mean 'resname GLU'?");
  CHECK(remedy("lysine 48") == "did you mean 'residue 48'?");
  CHECK(remedy("35") == "did you mean 'residue 35'?");
  CHECK(remedy("10-20") == "did you mean 'residue 10-20'?");
  CHECK(remedy("bonded element Fe") == "write: bonded to (element Fe)");
  CHECK(remedy("helixx") == "did you mean 'helix'?");
  CHECK(remedy("protien") == "did you mean 'protein'?");
}

TEST_CASE("every word of selections has a meaning for authors, and what stands by itself a noun and a fault") {
  std::set<std::string_view> seen;
  for (const SelectionWord& w : selectionWords()) {
    CAPTURE(w.word);
    CHECK(seen.insert(w.word).second);
    CHECK_FALSE(w.meaning.empty());
  }
  for (const AtomClass& c : atomClasses()) {
    CAPTURE(c.word);
    CHECK(seen.contains(c.word));
    CHECK(std::string_view(c.missing).find("{0}") != std::string_view::npos);
    CHECK_FALSE(std::string_view(c.noun).empty());
  }
}
