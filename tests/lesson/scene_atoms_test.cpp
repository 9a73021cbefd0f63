// Hidden and untouchable atoms of a scene: the keys, the atoms that they select, the checks of tasks on them, and their
// effect on tasks and scripted hands.
#include "engine/lesson/scene_atoms.h"

#include <doctest/doctest.h>

#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kSceneAtomsHead = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n";

using Atoms = std::vector<std::uint32_t>;

std::vector<std::string> sceneAtomsErrors(const std::string& body) {
  const auto mix = [](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
    return std::make_shared<const Molecule>(mixedMolecule());
  };
  std::vector<std::string> out;
  for (const Problem& p : checkLesson("l.md", kSceneAtomsHead + body, mix).errors) out.push_back(p.text());
  return out;
}

}  // namespace

TEST_CASE(
    "'hide' is for the eye, 'untouchable' for the hand, 'remove' for both, each until 'none' or another molecule") {
  const LessonReading reading = readLessonText(
      "l.md", kSceneAtomsHead +
                  "## A\n```scene\nmolecule: mix\nhide: name CA\nuntouchable: ligand\nremove: element Zn\n```\n"
                  "## B\n```scene\nprobe: 1 Å\n```\n## C\n```scene\nuntouchable: none\nremove: none\n```\n"
                  "## D\n```scene\nmolecule: mix\n```\n");
  REQUIRE(reading.lesson);
  const Molecule mix = mixedMolecule();
  const auto& steps = reading.lesson->steps;
  for (const std::size_t k : {0u, 1u}) {
    CHECK(hiddenAtoms(steps[k].scene, mix) == Atoms{1, 4, 9});
    CHECK(untouchableAtoms(steps[k].scene, mix) == Atoms{6, 7, 9});
  }
  CHECK(hiddenAtoms(steps[2].scene, mix) == Atoms{1, 4});
  CHECK(untouchableAtoms(steps[2].scene, mix).empty());
  CHECK(hiddenAtoms(steps[3].scene, mix).empty());
}

TEST_CASE(
    "a task on atoms of which none can be touched is reported at its place; one on atoms of which "
    "some can is not") {
  const std::string scene = "## S\n```scene\nmolecule: mix\nuntouchable: ligand\n```\n";
  CHECK(sceneAtomsErrors(scene + "```touch\nreach: name FE\nsay: Touch it.\n```\n") ==
        std::vector<std::string>{
            "l.md:15:8: nothing of this can be touched: the scene takes it from the hand; name other "
            "atoms, or change the scene's 'untouchable' or 'remove'"});
  CHECK(sceneAtomsErrors(scene + "```touch\nreach: name FE or name CA\nsay: Touch it.\n```\n").empty());
  CHECK(sceneAtomsErrors("## S\n```scene\nmolecule: mix\nremove: residue 999\n```\nText.\n").size() == 1);
}

TEST_CASE("'charges: file' on a molecule whose file has no charges is an error at its place; 'formal' is not") {
  const auto scene = [](const std::string& source) {
    return "## S\n```scene\nmolecule: mix\ncharges: " + source + "\n```\nText.\n";
  };
  CHECK(sceneAtomsErrors(scene("file")) ==
        std::vector<std::string>{"l.md:12:10: the file of 'mix' has no partial charges; write 'charges: formal', or "
                                 "give the molecule as a file with charges (.mol2 .pqr .pdbqt)"});
  CHECK(sceneAtomsErrors(scene("formal")).empty());
  CHECK(sceneAtomsErrors(scene("none")).empty());
  CHECK(sceneAtomsErrors(scene("guess")).size() == 1);
}

TEST_CASE("formal charges beside forces between atoms are warned of once, at their place; without them they are not") {
  const auto warnings = [](const std::string& keys) {
    const auto mix = [](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
      return std::make_shared<const Molecule>(mixedMolecule());
    };
    std::vector<std::string> out;
    for (const Problem& p :
         checkLesson("l.md", kSceneAtomsHead + "## S\n```scene\nmolecule: mix\n" + keys + "```\nText.\n", mix).warnings)
      if (p.message.find("formal charges") != std::string::npos) out.push_back(p.text());
    return out;
  };
  const std::vector<std::string> found = warnings("charges: formal\nforces: all\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].starts_with("l.md:12:10: formal charges replace the partial ones"));
  CHECK(warnings("charges: formal\n").empty());
  CHECK(warnings("charges: formal\nforces: van-der-waals\n").empty());
  CHECK(warnings("forces: all\n").empty());
}

TEST_CASE("a view that faces 9 of 10 atoms that are left, or all, is warned of at its place; one that faces 8 is not") {
  const auto warnings = [](const std::string& keys) {
    const auto mix = [](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
      return std::make_shared<const Molecule>(mixedMolecule());
    };
    std::vector<std::string> out;
    for (const Problem& p :
         checkLesson("l.md", kSceneAtomsHead + "## S\n```scene\nmolecule: mix\n" + keys + "```\nText.\n", mix).warnings)
      out.push_back(p.text());
    return out;
  };
  const Molecule mix = mixedMolecule();
  REQUIRE(mix.atoms.size() == 10);
  const std::vector<std::string> reported{
      "l.md:12:14: nearly all atoms that the scene has left cannot be in front of the others; the molecule is seen "
      "along its "
      "thinnest axis; name the atoms that are to be in front, or write 'turned' and angles"};
  CHECK(warnings("view: facing all\n") == reported);
  CHECK(warnings("view: facing not element Zn\n") == reported);
  CHECK(warnings("view: facing element Zn\n").empty());
  CHECK(warnings("view: facing ligand\n").empty());
  CHECK(warnings("view: facing not ligand\nremove: ligand\n") == reported);
}
