// The keys of a scene for labels, arrows, marks and measurements: their parsing, their inheritance by later scenes, and
// the messages about errors.
#include <doctest/doctest.h>

#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const KeySpec& keyNamed(std::string_view name) {
  for (const KeySpec& key : keysOf(KeyBlock::Scene))
    if (key.name == name) return key;
  FAIL("no such key");
  return keysOf(KeyBlock::Scene)[0];
}

Value good(std::string_view key, std::string_view text) {
  CAPTURE(text);
  Expected<Value> value = parseValue(keyNamed(key), text);
  if (!value) FAIL(value.problem().text());
  return *std::move(value);
}

Problem bad(std::string_view key, std::string_view text) {
  CAPTURE(text);
  const Expected<Value> value = parseValue(keyNamed(key), text);
  REQUIRE_FALSE(value);
  return value.problem();
}

std::string lesson(const std::string& first, const std::string& second) {
  return "---\ntitle: T\nminutes: 1\ngoals: g\nmolecules: m\nauthor: A\nlicence: CC0\n---\n\n## "
         "One\n\n```scene\nmolecule: "
         "m\n" +
         first + "```\n\nText.\n\n## Two\n\n```scene\n" + second + "```\n\nText.\n";
}

}  // namespace

TEST_CASE("labels are words, or names in quotes, each for its atoms; a comma in quotes parts nothing") {
  const std::vector<MarkSpec> marks =
      good("label", "residue for ligand, \"the cleft, open\" for residue 35 52, chain").marks;
  REQUIRE(marks.size() == 3);
  CHECK(marks[0].word == "residue");
  CHECK(marks[0].atoms.text() == "ligand");
  CHECK(marks[0].place.column == 13);
  CHECK(marks[1].name == "the cleft, open");
  CHECK(marks[1].word.empty());
  CHECK(marks[1].atoms.text() == "residue 35 52");
  CHECK(marks[2].word == "chain");
  CHECK_FALSE(marks[2].atoms.given());
  CHECK(good("label", "none").marks.empty());
}

TEST_CASE("marks have a colour, a name or both") {
  const std::vector<MarkSpec> marks =
      good("mark", "teal \"acid\" for residue 35, \"base\" for residue 52, rose for chain A").marks;
  REQUIRE(marks.size() == 3);
  CHECK(marks[0].word == "teal");
  CHECK(marks[0].name == "acid");
  CHECK(marks[1].word.empty());
  CHECK(marks[2].name.empty());
}

TEST_CASE("a distance has two places and an angle three or four, whose residues may be ranges with a hyphen") {
  const std::vector<PlacesSpec> two = good("distance", "residue 10-20 - ligand, name \"A - B\" - atom 3").measures;
  REQUIRE(two.size() == 2);
  CHECK(two[0].atoms[0].text() == "residue 10-20");
  CHECK(two[0].places[1].column == 17);
  CHECK(two[1].atoms[0].text() == "name \"A - B\"");
  CHECK(good("angle", "atom 1 - atom 2 - atom 3 - atom 4").measures[0].atoms.size() == 4);
  CHECK(bad("distance", "atom 1").message == "'distance' is between two places");
  CHECK(bad("angle", "atom 1 - atom 2").remedy.find("three") != std::string::npos);
  CHECK(bad("angle", "atom 1 - atom 2 - atom 3 - atom 4 - atom 5").message ==
        "'angle' is between three places or four");
  CHECK(bad("distance", "atom 1 - ").message == "a place is missing beside '-'");
  CHECK(bad("distance", "atom 1 - atom x").column == 15);
}

TEST_CASE("typing errors are reported with their place") {
  CHECK(bad("label", "residues").remedy == "did you mean 'residue'?");
  CHECK(bad("label", "chain, resdue for ligand").column == 8);
  CHECK(bad("label", "\"open for residue 3").message == "the name has no end");
  CHECK(bad("label", "\"cleft\"").message == "a name needs its atoms");
  CHECK(bad("label", "\"\" for residue 3").message == "a name has 1 to 80 characters");
  CHECK(bad("label", "residue ligand").message == "'ligand' is not understood here");
  CHECK(bad("label", "chain, none").message == "'none' stands alone");
  CHECK(bad("label", "chain,").message == "a word is missing");
  CHECK(bad("mark", "orange for residue 3").message == "'mark' cannot be 'orange'");
  CHECK(bad("label", "residue for chian A").column == 13);
}

TEST_CASE("a later scene keeps what it does not say, 'none' ends it, and lengths and angles are kept apart") {
  const auto read = [](const std::string& first, const std::string& second) {
    LessonReading reading = readLessonText("l.md", lesson(first, second));
    for (const Problem& p : reading.errors) FAIL(p.text());
    return reading.lesson->steps.at(1).scene;
  };
  const std::string all =
      "label: chain\narrow: \"iron\" for element Fe\nmark: teal for atom 1\ndistance: atom 1 - atom 2\n"
      "angle: atom 1 - atom 2 - atom 3\nhydrogen-bonds: ligand\npaint: touched\n";
  const SceneSpec kept = read(all, "view: top\n");
  CHECK(kept.labels.size() == 1);
  CHECK(kept.arrows.size() == 1);
  CHECK(kept.marks.size() == 1);
  CHECK(kept.measures.size() == 2);
  CHECK(kept.hydrogen_bonds.text() == "ligand");
  CHECK(kept.paint_touched);
  const SceneSpec ended =
      read(all, "label: none\narrow: none\nmark: none\ndistance: none\nhydrogen-bonds: none\npaint: none\n");
  CHECK(ended.labels.empty());
  CHECK(ended.arrows.empty());
  CHECK(ended.marks.empty());
  REQUIRE(ended.measures.size() == 1);
  CHECK(ended.measures[0].atoms.size() == 3);
  CHECK_FALSE(ended.hydrogen_bonds.given());
  CHECK_FALSE(ended.paint_touched);
  const SceneSpec anew = read(all, "molecule: m\n");
  CHECK(anew.labels.empty());
  CHECK(anew.measures.empty());
  CHECK_FALSE(anew.paint_touched);
}

TEST_CASE("a label, arrow, mark, distance or hydrogen bond for atoms that are not there is an error at its place") {
  const auto mixed = std::make_shared<const Molecule>(mixedMolecule());
  const MoleculeByName byName = [&](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
    return mixed;
  };
  for (const char* line :
       {"label: residue for chain Q\n", "arrow: \"x\" for element Xe\n", "mark: teal for resname TRP\n",
        "distance: atom 0 - atom 99\n", "hydrogen-bonds: ligand XYZ\n"}) {
    CAPTURE(line);
    const LessonCheck check = checkLesson("l.md", lesson(line, "view: top\n"), byName);
    REQUIRE(check.errors.size() == 1);
    CHECK(check.errors[0].line == 14);
    CHECK(check.errors[0].column > 10);
  }
  CHECK(checkLesson("l.md", lesson("label: residue for chain A\ndistance: atom 0 - atom 3\n", "view: top\n"), byName)
            .errors.empty());
}
