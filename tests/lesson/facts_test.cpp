// Facts: what a lesson states about its molecules in numbers, and that a false number is reported.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/lesson_texts.h"
#include "tests/lesson/shipped_lesson.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;
using namespace moltact::test;

namespace {

/// Chain A: a square of carbons of 1.7 A, 3 A wide, in the plane z = 0; chain B: a nitrogen of 1.5 A, 4 A above its middle,
/// and a water 20 A away.
std::shared_ptr<const Molecule> square(bool waters) {
  MoleculeByHand b;
  b.made.id = "square";
  b.residue("A", "RNG", 1, ResidueKind::Ligand)
      .atom("C1", 6, {0, 0, 0})
      .atom("C2", 6, {3, 0, 0})
      .atom("C3", 6, {3, 3, 0})
      .atom("C4", 6, {0, 3, 0});
  b.residue("B", "AMM", 2, ResidueKind::Ligand).atom("N", 7, {1.5, 1.5, 4}, 1.5);
  if (waters) b.residue("B", "HOH", 3, ResidueKind::Water).atom("O", 8, {20, 1.5, 4}, 1.5);
  return std::make_shared<const Molecule>(b.molecule());
}

Expected<std::shared_ptr<const Molecule>> bySquare(const NamedMolecule& named) { return square(named.reading.waters); }

/// A lesson whose only step has this block of facts, which begins on line 20.
std::string lessonWith(const std::string& facts, const std::string& scene = "") {
  return "---\ntitle: T\ngoals:\n  - G\nmolecules:\n  - square\nauthor: A\nlicence: L\n---\n\n## "
         "One\n\n```scene\nmolecule: "
         "square\n" +
         (scene.empty() ? "probe: 1.4 Å" : scene) + "\n```\n\nText.\n\n```facts\n" + facts + "\n```\n";
}

std::string factsJoined(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  return out;
}

/// The false facts of such a lesson, each as "line:column: message; remedy".
std::string falseOf(const std::string& facts, const std::string& scene = "") {
  const LessonReading read = readLessonText("l.md", lessonWith(facts, scene));
  for (const Problem& p : read.errors) FAIL_CHECK(p.text());
  REQUIRE(read.lesson);
  std::vector<std::string> out;
  for (const Problem& p : checkFacts(*read.lesson, bySquare)) out.push_back(p.text());
  return factsJoined(out);
}

/// The errors and warnings of a lesson that cannot be read.
std::string faultsOf(const std::string& facts) {
  std::vector<std::string> out;
  const LessonReading read = readLessonText("l.md", lessonWith(facts));
  for (const auto* list : {&read.errors, &read.warnings})
    for (const Problem& p : *list) out.push_back(p.text());
  return factsJoined(out);
}

constexpr const char* kCorrect = "; correct the number here and in the text, or select other atoms";

}  // namespace

TEST_CASE("each kind of fact is computed as its key says: a square of carbons, 3 A wide, below a nitrogen") {
  // The nitrogen is sqrt(1.5^2 + 1.5^2 + 4^2) = 4.528 A from each carbon. Seen from a sphere of 1.4 A on two carbons, these
  // are 2 asin(1.5 / 3.1) = 57.9 degrees apart. A sphere that passes the opening of the square has 3 / sqrt(2) - 1.7 =
  // 0.42 A.
  CHECK(falseOf(R"(atoms:
- all = 5
- chain B and element C = 0
residues: all = 2
chains: all = 2
nearest:
- element N - element C = 4.53 Å
- element C - element C = 3 Å
- element N - element C = 0.453 nm
farthest: element C - element C = 4.24 Å
distance: element N - element C = 4.0 Å
gap: element N - element C = 1.33 Å
out-of-plane: element N - element C = 4.00 Å
radius: element C = 1.7 Å
angle:
- name C1 - name C2 - name C3 = 90°
- name C1 - name C2 - name C3 - name N = 67.3 ° to 70 °
turn: name C1 - name C2 = 57.9°
touched:
- element C = 4
- element C > 3
- element C < 5
reached: all = 5
share: element N = 69.6 %
largest: element N = 20 Å)")
            .empty());
}

TEST_CASE("a false fact is reported with its line, the stated and the computed value, and a remedy") {
  CHECK(falseOf("nearest:\n- element N - element C = 4.52 Å\n- element N - element C = 4.53 Å\natoms: all = 6") ==
        factsJoined({std::string("l.md:22:3: 'nearest' is stated as 4.52 Å, but computed as 4.528 Å") + kCorrect,
                     std::string("l.md:24:8: 'atoms' is stated as 6, but computed as 5") + kCorrect}));
  CHECK(falseOf("touched: element C < 4\nturn: name C1 - name C2 = 57.0° to 57.8°\nshare: element N = 3 %") ==
        factsJoined({std::string("l.md:21:10: 'touched' is stated as 4, but computed as 4") + kCorrect,
                     std::string("l.md:22:7: 'turn' is stated as 57.0° to 57.8°, but computed as 57.88°") + kCorrect,
                     std::string("l.md:23:8: 'share' is stated as 3 %, but computed as 69.6 %") + kCorrect}));
}

TEST_CASE("a fact that its atoms do not allow is reported, except a count of none") {
  CHECK(falseOf("atoms: element Fe = 0").empty());
  CHECK(falseOf("radius: element Fe = 1 Å") ==
        factsJoined({"l.md:21:17: element 'Fe' is not in square (elements: C, N); name atoms that it has"}));
  CHECK(falseOf("radius: all = 1.7 Å") ==
        factsJoined({"l.md:21:9: these atoms differ in radius; select atoms of one element"}));
  CHECK(falseOf("nearest: name C1 - name C1 = 0 Å") ==
        factsJoined({"l.md:21:10: both selections are the same atom; select two atoms"}));
  CHECK(falseOf("turn: all - name N = 5°") ==
        factsJoined({"l.md:21:7: the force turns between two atoms, but more are selected; select one on each side"}));
  CHECK(falseOf("probe: 0.1 Å\nturn: name C1 - name N = 5°") ==
        factsJoined({"l.md:22:7: the probe does not touch both atoms at once; select neighbours, or a larger probe"}));
  CHECK(falseOf("out-of-plane: name N - name C1 C2 = 4 Å") ==
        factsJoined({"l.md:21:15: a plane needs three atoms or more; select more behind the ' - '"}));
  CHECK(falseOf("share: all = 5 %") == factsJoined({"l.md:21:8: 'share' is about one atom; select one"}));
  CHECK(falseOf("remove: element Fe\natoms: all = 5") ==
        factsJoined({"l.md:21:9: element 'Fe' is not in square (elements: C, N); name atoms that it has"}));
}

TEST_CASE("facts are read as the scene reads its molecule, unless the block names one") {
  CHECK(falseOf("atoms: water = 1", "waters: yes").empty());
  CHECK(falseOf("atoms: all = 1", "waters: yes\nremove: chain A or water").empty());
  CHECK(falseOf("molecule: square\natoms: all = 5", "waters: yes\nremove: chain A").empty());
  CHECK(falseOf("waters: yes\natoms: water = 1").empty());
  CHECK(falseOf("remove: none\natoms: all = 5", "remove: chain A").empty());
  // The probe of the scene, and one of the block.
  CHECK(falseOf("turn: name C1 - name C2 = 123.9°", "probe: 0 Å").empty());
  CHECK(falseOf("probe: 1.4 Å\nturn: name C1 - name C2 = 57.9°", "probe: 0 Å").empty());
}

TEST_CASE("what is no fact is reported where it stands") {
  const std::string as_count = "write it as 'chain A and name CA = 146'";
  CHECK(faultsOf("atoms: all") ==
        factsJoined({"l.md:21:8: no ' = ' separates the atoms from the number; " + as_count}));
  CHECK(faultsOf("atoms:\n- all = 5\n- all = 1.5") == factsJoined({"l.md:23:9: '1.5' is not a whole number"}));
  CHECK(faultsOf("nearest: all = 5 Å") ==
        factsJoined(
            {"l.md:21:10: 'nearest' is computed from 2 selections, not from 1; write it as 'residue 35 - residue 52 = "
             "5.8 Å'"}));
  CHECK(faultsOf("nearest: all - elemnt C = 5 Å") ==
        factsJoined({"l.md:21:16: 'elemnt' is no word of a selection; did you mean 'element'?"}));
  CHECK(faultsOf("radius: all = 5") == factsJoined({"l.md:21:15: '5' needs a unit: Å or nm"}));
  CHECK(faultsOf("angle: all - all - all = 5 Å") ==
        factsJoined({"l.md:21:26: '5 Å' is a length, but an angle is needed: °"}));
  CHECK(faultsOf("radius: all = 5 Å to 4 Å") ==
        factsJoined({"l.md:21:15: the range ends below its start; write the smaller value first"}));
  CHECK(faultsOf("atom: all = 5").starts_with("l.md:21:1: facts has no key 'atom'; did you mean 'atoms'?"));
  CHECK(faultsOf("probe: 2 Å") ==
        factsJoined({"l.md:20:4: this block states no fact; add one, or take the block out"}));
  CHECK(faultsOf("molecule: squre\natoms: all = 5") ==
        factsJoined({"l.md:21:11: 'squre' is not among the lesson's molecules; did you mean 'square'?"}));
}

TEST_CASE("nothing of a block of facts is shown") {
  const LessonReading read = readLessonText("l.md", lessonWith("atoms: all = 5"));
  REQUIRE(read.lesson);
  const Step& step = read.lesson->steps[0];
  REQUIRE(step.facts.size() == 1);
  CHECK(step.blocks.size() == 1);
  forEachText(step, [](const RichText& text) { CHECK(plainText(text) == "Text."); });
}

TEST_CASE("every fact of the shipped lessons is true, and their text says the number of each that is measured") {
  std::size_t facts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons")) {
    if (!looksLikeLesson(entry.path())) continue;
    const std::string name = entry.path().stem().string();
    CAPTURE(name);
    const Lesson lesson = shippedLesson(name);
    for (const Problem& p : checkFacts(lesson, shippedMolecule)) FAIL_CHECK(p.text());
    std::ifstream in(entry.path());
    std::string text, line;
    for (bool in_facts = false; std::getline(in, line);) {
      in_facts = line == "```facts" || (in_facts && line != "```");
      if (!in_facts) text += line + '\n';
    }
    for (const Step& step : lesson.steps)
      for (const FactsSpec& block : step.facts)
        for (const auto& [kind, fact] : block.facts) {
          ++facts;
          std::istringstream words(fact.stated);
          for (std::string word; fact.relation == FactSpec::Relation::Equal && words >> word;) {
            const std::string number = word.substr(word.starts_with('-'), word.find("°") - word.starts_with('-'));
            if (fact.half_digit > 0.0 && number.find_first_not_of("0123456789.") == std::string::npos)
              CHECK_MESSAGE(text.find(number) != std::string::npos, name << ':' << fact.place.line << ": " << number);
          }
        }
  }
  CHECK(facts >= 150);
}
