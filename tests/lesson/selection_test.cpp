#include "engine/lesson/selection.h"

#include <doctest/doctest.h>

#include <random>

#include "engine/lesson/selection_node.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {
using Atoms = std::vector<std::uint32_t>;

Atoms atoms(std::string_view text) {
  const auto s = parseSelection(text);
  REQUIRE_MESSAGE(s, std::string(text), ": ", s ? "" : s.problem().message);
  return s->select(mixedMolecule());
}
std::string selectionReported(std::string_view text) {
  const auto s = parseSelection(text);
  REQUIRE_MESSAGE(!s, text);
  return std::to_string(s.problem().column) + " " + s.problem().text();
}
}  // namespace

TEST_CASE("each word of the language selects its atoms of a 10-atom molecule") {
  CHECK(atoms("all").size() == 10);
  CHECK(atoms("chain A") == Atoms{0, 1, 2, 3, 4});
  CHECK(atoms("residue 52") == Atoms{0, 1, 2, 3, 4});
  CHECK(atoms("residue 52A") == Atoms{4});
  CHECK(atoms("residue -1") == Atoms{5});
  CHECK(atoms("residue -1-1") == Atoms{5, 6, 7});
  CHECK(atoms("resname HEM DA") == Atoms{5, 6, 7});
  CHECK(atoms("name CA") == Atoms{1, 4});
  CHECK(atoms("element O") == Atoms{3, 8});
  CHECK(atoms("element FE, zn") == Atoms{6, 9});
  CHECK(atoms("atom 3 5-7") == Atoms{3, 5, 6, 7});
  CHECK(atoms("ligand") == Atoms{6, 7});
  CHECK(atoms("ligand HEM") == Atoms{6, 7});
  CHECK(atoms("ligand BTN").empty());
  CHECK(atoms("protein") == Atoms{0, 1, 2, 3, 4});
  CHECK(atoms("nucleic") == Atoms{5});
  CHECK(atoms("water") == Atoms{8});
  CHECK(atoms("ion") == Atoms{9});
}

TEST_CASE("not binds before and, and before or; brackets group") {
  CHECK(atoms("chain A and name CA") == Atoms{1, 4});
  CHECK(atoms("name N or name O and water") == Atoms{0, 8});
  CHECK(atoms("(name N or name O) and not water") == Atoms{0, 3});
  CHECK(atoms("not chain A and not ligand") == Atoms{5, 8, 9});
  CHECK(atoms("not not ion") == Atoms{9});
  CHECK(atoms("name \"CA\"") == Atoms{1, 4});
}

TEST_CASE("within 4 Å of the ligand are the atoms up to 4 Å away, edge and ligand included") {
  CHECK(atoms("within 4 Å of ligand") == Atoms{2, 3, 4, 6, 7});
  CHECK(atoms("within 0.3 nm of (resname HEM)") == Atoms{3, 4, 6, 7});
  CHECK(atoms("protein and within 3 Å of ligand") == Atoms{3, 4});
  CHECK(atoms("within 5 Å of resname XXX").empty());
}

TEST_CASE("within agrees with a loop over all pairs of 400 random atoms") {
  const unsigned seed = 11;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-15, 15);
  MoleculeByHand b;
  for (int i = 0; i < 400; ++i)
    b.atom("C", i % 10 == 0 ? 8 : 6, {coordinate(random), coordinate(random), coordinate(random)});
  const auto all = b.atoms;
  for (const double d : {0.0, 1.0, 5.0, 100.0}) {
    Atoms expected;
    for (std::uint32_t i = 0; i < all.size(); ++i)
      for (const PlacedAtom& o : all)
        if (o.atomic_number == 8 && glm::distance(o.position.A, all[i].position.A) <= d) {
          expected.push_back(i);
          break;
        }
    CHECK(parseSelection("within " + std::to_string(d) + " Å of element O")->select(b.molecule()) == expected);
  }
}

TEST_CASE("a faulty selection is reported with its column and what would mend it") {
  CHECK(selectionReported("") == "1 a selection is missing; for example: resname HEM");
  CHECK(selectionReported("resnam HEM") == "1 'resnam' is no word of a selection; did you mean 'resname'?");
  CHECK(selectionReported("chain A and") == "12 the selection ends too early; for example: resname HEM");
  CHECK(selectionReported("chain A name") == "9 'name' does not belong here; join two selections with 'and' or 'or'");
  CHECK(selectionReported("chain") == "6 'chain' needs something after it; for example: chain A");
  CHECK(selectionReported("(chain A") == "1 an opening bracket without its closing one; add ')'");
  CHECK(selectionReported("chain A)") == "8 a closing bracket without its opening one; take it out");
  CHECK(selectionReported("element Xx") == "9 'Xx' is no chemical element; write its symbol: C, N, O, Fe");
  CHECK(selectionReported("residue CA") == "9 'CA' is no residue number; write 52, 10-20 or 52A");
  CHECK(selectionReported("residue 20-10") == "9 '20-10' is no residue number; write 52, 10-20 or 52A");
  CHECK(selectionReported("atom -1") == "6 '-1' is no atom number; atoms are counted from 0: write 3 or 0-5");
  CHECK(selectionReported("within 5 of ligand") == "8 '5' needs a unit: Å or nm");
  CHECK(selectionReported("within 5 Å ligand") ==
        "18 'within' needs a distance and 'of'; write: within 5 Å of (resname HEM)");
  CHECK(selectionReported("name \"CA") == "6 a quotation mark without its partner; close the name with \"");
  CHECK(selectionReported(std::string(500, '(')) == "65 the selection is nested too deeply; use fewer brackets");
}

TEST_CASE("each word that needs something after it says so with an example that is itself a sound selection") {
  std::size_t needing = 0;
  for (const SelectionWord& word : selectionWords()) {
    CAPTURE(std::string(word.word));
    const auto alone = parseSelection(word.word);
    const bool needs = word.takes != SelectionWord::Takes::Nothing && word.takes != SelectionWord::Takes::OptionalNames;
    CHECK(bool(alone) != needs);
    if (!needs || alone) continue;
    ++needing;
    const std::string remedy = alone.problem().remedy, lead = "for example: ";
    REQUIRE(remedy.starts_with(lead + std::string(word.word) + ' '));
    CHECK(bool(parseSelection(remedy.substr(lead.size()))));
  }
  CHECK(needing == 6);
}

TEST_CASE("an empty selection says at which column its first part without atoms stands, and what there is instead") {
  const Molecule m = mixedMolecule();
  const auto why = [&](const char* text) {
    const Problem p = parseSelection(text)->whyEmpty(m);
    return std::to_string(p.column) + " " + p.text();
  };
  CHECK(why("ligand BTX") == "8 ligand 'BTX' is not in mix (ligands: HEM); name atoms that it has");
  CHECK(why("chain A and resname GLU") ==
        "21 residue name 'GLU' is not in mix (names: ASP, DA, HEM, HOH, ZN); name atoms that it has");
  CHECK(why("resname hem") ==
        "9 residue name 'hem' is not in mix (names: ASP, DA, HEM, HOH, ZN); did you mean 'HEM'? Names are written as "
        "in the file");
  CHECK(why("resname AXP") == "9 residue name 'AXP' is not in mix (names: ASP, DA, HEM, HOH, ZN); did you mean 'ASP'?");
  CHECK(why("chain C") == "7 chain 'C' is not in mix (chains: A, B); name atoms that it has");
  CHECK(why("atom 12") == "6 atom 12 is not in mix (10 atoms, counted from 0); name atoms that it has");
  CHECK(why("within 5 Å of (residue 99)") ==
        "24 residue 99 is not in mix (residues: -1 to 52); name atoms that it has");
  CHECK(why("chain A and ligand") == "1 no atom of mix is 'chain A and ligand'; name atoms that it has");
}

TEST_CASE("names and numbers that select nothing beside others that do are reported one by one") {
  const Molecule m = mixedMolecule();
  const auto idle = [&](const char* text) {
    std::string out;
    for (const Problem& p : parseSelection(text)->unmatchedNames(m))
      out += std::to_string(p.column) + " " + p.message + "|";
    return out;
  };
  CHECK(
      idle("resname HEM HEX or chain A D") ==
      "13 residue name 'HEX' is not in mix (names: ASP, DA, HEM, HOH, ZN)|28 chain 'D' is not in mix (chains: A, B)|");
  CHECK(idle("residue 50-60 99") == "15 residue 99 is not in mix (residues: -1 to 52)|");
  CHECK(idle("not element O U") == "15 element 'U' is not in mix (elements: C, Fe, N, O, P, Zn)|");
  CHECK(idle("resname HEM").empty());
  CHECK(idle("chain A B").empty());
}

TEST_CASE("a selection has a name for the middle of a sentence") {
  CHECK(parseSelection("element O")->noun() == "an oxygen atom");
  CHECK(parseSelection("element C")->noun() == "a carbon atom");
  CHECK(parseSelection("residue 52")->noun() == "residue 52");
  CHECK(parseSelection("ligand HEM")->noun() == "the ligand HEM");
  CHECK(parseSelection("chain A and residue 52")->noun() == "the place you look for");
}
