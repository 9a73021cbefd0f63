// Named views, the cut, the second structure of a scene, and links that change the scene: their parsing, and the
// messages about mistakes in them.
#include <doctest/doctest.h>

#include "engine/lesson/check.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scene_link.h"
#include "engine/lesson/second_state.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kHead = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix, shut\nauthor: A\nlicence: L\n---\n";

// A bend of five residues; shut, the last has moved by 4 A.
Molecule bend(double last_y) {
  MoleculeByHand b;
  b.made.id = "mix";
  for (int k = 0; k < 5; ++k)
    b.residue("A", "GLY", k + 1, ResidueKind::AminoAcid)
        .atom("CA", 6,
              {3.8 * k,
               k == 4  ? last_y
               : k % 2 ? 1.0
                       : 0.0,
               k == 2 ? 1.5 : 0.0});
  return b.molecule();
}

Expected<std::shared_ptr<const Molecule>> molecules(const NamedMolecule& named) {
  if (named.name == "mix") return std::make_shared<const Molecule>(bend(0.0));
  if (named.name == "shut") return std::make_shared<const Molecule>(bend(4.0));
  if (named.name == "other") return std::make_shared<const Molecule>(mixedMolecule());
  return Problem{{}, 0, 0, "there is no molecule '" + named.name + "'", {}};
}

std::vector<std::string> errors(const std::string& body) {
  std::vector<std::string> out;
  for (const Problem& p : checkLesson("l.md", kHead + body, molecules).errors)
    if (p.message.find("no scene uses") == std::string::npos) out.push_back(p.text());
  return out;
}

SceneSpec sceneOf(const std::string& keys) {
  LessonReading reading = readLessonText("l.md", kHead + "## S\n```scene\nmolecule: mix\n" + keys + "```\n");
  for (const Problem& p : reading.errors) INFO(p.text());
  REQUIRE(reading.lesson);
  return reading.lesson->steps[0].scene;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("a view is a side, atoms to the front or angles, and comes close to atoms behind 'zoom'") {
  CHECK(sceneOf("view: top, zoom residue 2\n").view.side == "top");
  CHECK(sceneOf("view: top, zoom residue 2\n").view.zoom.text() == "residue 2");
  const ViewSpec facing = sceneOf("view: facing residue 1, zoom residue 1 or name \"A,B\"\n").view;
  CHECK((facing.side.empty() && facing.facing.text() == "residue 1" &&
         facing.zoom.text() == "residue 1 or name \"A,B\""));
  const ViewSpec turned = sceneOf("view: turned 30° -10.5\n").view;
  REQUIRE(turned.turned_deg);
  CHECK(*turned.turned_deg == std::array{30.0, -10.5, 0.0});
  const ViewSpec close = sceneOf("view: zoom residue 2\n").view;
  CHECK((close.side == "side" && close.zoom.text() == "residue 2"));
  const auto part = zoomedRegion(close, SceneSpec(), bend(0.0), 1.4);
  REQUIRE(part);
  CHECK(glm::distance(part->centre.A, Vec3(3.8, 1, 0)) < 1e-12);
  CHECK(part->radius_A == doctest::Approx(1.7 + 1.4));
}

TEST_CASE(
    "views keep their names and order; one of a later scene takes the place of its namesake, a molecule begins again") {
  const LessonReading reading = readLessonText(
      "l.md",
      kHead +
          "## A\n```scene\nmolecule: mix\nview the Cleft: top\nview back: back\n```\n"
          "## B\n```scene\nview the cleft: bottom\nview third: left\n```\n## C\n```scene\nmolecule: shut\n```\n");
  REQUIRE(reading.lesson);
  const auto& steps = reading.lesson->steps;
  REQUIRE(steps[0].scene.views.size() == 2);
  CHECK(steps[0].scene.views[0].name == "the Cleft");
  REQUIRE(steps[1].scene.views.size() == 3);
  REQUIRE(findView(steps[1].scene, "the-cleft"));
  CHECK(findView(steps[1].scene, "the-cleft")->view.side == "bottom");
  CHECK(steps[2].scene.views.empty());
}

TEST_CASE("mistakes in views are reported at their places") {
  const auto scene = [](const std::string& keys) {
    return errors("## S\n```scene\nmolecule: mix\n" + keys + "```\nText.\n");
  };
  CHECK(scene("view: tpo\n") == Texts{"l.md:12:7: 'view' cannot be 'tpo'; did you mean 'top'?"});
  CHECK(
      scene("view a: top, zooom residue 1\n") ==
      Texts{
          "l.md:12:14: 'zooom residue 1' is not understood after the comma; write 'zoom' and the atoms, as in 'front, "
          "zoom ligand'"});
  CHECK(scene("view: turned 30\n").size() == 1);
  CHECK(scene("view: turned 30 10 0 5\n").size() == 1);
  CHECK(scene("view a: top, zoom residue 99\n").size() == 1);
  CHECK(scene("view a: top\nview a: left\n") == Texts{"l.md:13:1: 'view a' is given twice; take one of the two out"});
  CHECK(scene("view a b: top\nview a-b: left\n").size() == 1);
  CHECK(scene("viw a: top\n").size() == 1);
}

TEST_CASE("links to views, atoms and states are checked against the scene of their step") {
  const std::string scene =
      "## S\n```scene\nmolecule: mix\nview the cleft: top\nthen: shut\nstates: open, all shut\n```\n";
  CHECK(errors(scene + "[a](#view:the-cleft) [b](<#zoom:residue 1 2>) [c](#state:all-shut) [d](#state:40%) "
                       "[e](<#state:open>)\n")
            .empty());
  CHECK(errors(scene + "[a](#view:the-clift)\n") ==
        Texts{"l.md:16:5: the scene has no view 'the-clift'; did you mean 'the-cleft'?"});
  CHECK(errors(scene + "[a](<#zoom:residue 77>)\n").size() == 1);
  CHECK(errors(scene + "[a](<#zoom:residoo 1>)\n").size() == 1);
  CHECK(errors(scene + "[a](#state:ajar)\n").size() == 1);
  CHECK(errors("## S\n```scene\nmolecule: mix\n```\n[a](#state:50%)\n").size() == 1);
}

TEST_CASE("'cut' is 'none', the middle or atoms, and continues until a scene says otherwise") {
  CHECK_FALSE(sceneOf("").cut);
  CHECK((sceneOf("cut: middle\n").cut && !sceneOf("cut: middle\n").cut_at.given()));
  CHECK(sceneOf("cut: residue 3\n").cut_at.text() == "residue 3");
  const LessonReading reading = readLessonText(
      "l.md", kHead + "## A\n```scene\nmolecule: mix\ncut: residue 3\n```\n## B\n```scene\ncut: none\n```\n");
  REQUIRE(reading.lesson);
  CHECK((!reading.lesson->steps[1].scene.cut && !reading.lesson->steps[1].scene.cut_at.given()));
}

TEST_CASE("a second structure has names for both states and a place to begin; it is read as the first is") {
  const SceneSpec scene =
      sceneOf("waters: yes\nthen: shut, superposed on residue 1-4\nstates: open, shut\nstate: shut\n");
  CHECK((secondMolecule(scene).name == "shut" && secondMolecule(scene).reading.waters));
  CHECK(scene.then.superposed_on.text() == "residue 1-4");
  CHECK(scene.then.share == 1.0);
  CHECK((stateName(scene, 0) == "open" && stateName(scene, 1) == "shut"));
  CHECK(sceneOf("then: shut\nstate: 25%\n").then.share == 0.25);
  CHECK(stateName(sceneOf("then: shut\n"), 1) == "shut");
  const auto states = statesOf(scene, bend(0.0), bend(4.0));
  REQUIRE(states);
  CHECK(states->fit.fitted == 4);
  CHECK(glm::distance(states->second[4].centre_A, Vec3(15.2, 4, 0)) < 1e-9);
  CHECK(glm::distance(bend(0.0).movedTo(states->at(0.5)).spheres[4].centre_A, Vec3(15.2, 2, 0)) < 1e-9);
  // What swells under the hand is drawn so too.
  std::vector<Sphere> swollen = bend(0.0).spheres.copy();
  swollen[4].radius_A = 2.25;
  CHECK(bend(0.0).movedTo(swollen).spheres[4].radius_A == 2.25);
}

TEST_CASE("mistakes in the second structure are reported") {
  const auto scene = [](const std::string& keys) {
    return errors("## S\n```scene\nmolecule: mix\n" + keys + "```\nText.\n");
  };
  CHECK(scene("then: shut\n").empty());
  const Texts misspelt = scene("then: sht\n");
  REQUIRE_FALSE(misspelt.empty());
  CHECK(misspelt[0] == "l.md:12:7: 'sht' is not among the lesson's molecules; did you mean 'shut'?");
  CHECK(scene("then: shut, superposed on residue 88\n").size() == 1);
  CHECK(scene("then: shut\nstates: open\n").size() == 1);
  CHECK(scene("then: shut\nstate: ajar\n").size() == 1);
  CHECK(scene("then: shut\nstate: 140%\n").size() == 1);
  CHECK(scene("state: 40%\n").size() == 1);
  const std::string other = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix, other\nauthor: A\nlicence: L\n---\n";
  const LessonCheck apart =
      checkLesson("l.md", other + "## S\n```scene\nmolecule: mix\nthen: other\n```\nText.\n", molecules);
  REQUIRE(apart.errors.size() == 1);
  CHECK(apart.errors[0].text() ==
        "l.md:12:7: only 0 atoms are in both structures; take two structures of one molecule, with the same chains and "
        "residue numbers");
}

TEST_CASE("a scene has a second molecule beside its own, with captions; the list of molecules must have it") {
  const SceneSpec scene = sceneOf("beside: shut\ncaptions: open, closed\nwaters: yes\n");
  CHECK(scene.molecule.reading.beside == "shut");
  CHECK(scene.captions == std::vector<std::string>{"open", "closed"});
  CHECK((besideMolecule(scene).name == "shut" && besideMolecule(scene).reading == ReadOptions{.waters = true}));
  CHECK(sceneOf("beside: none\n").molecule.reading == ReadOptions());
  // One that a later scene takes away again.
  const LessonReading reading =
      readLessonText("l.md", kHead +
                                 "## A\n```scene\nmolecule: mix\nbeside: shut\n```\n## B\n```scene\nbeside: "
                                 "none\n```\n## C\n```scene\nmolecule: mix\n```\n");
  REQUIRE(reading.lesson);
  CHECK(reading.lesson->steps[0].scene.molecule.reading.beside == "shut");
  CHECK(reading.lesson->steps[1].scene.molecule.reading.beside.empty());
  CHECK(reading.lesson->steps[2].scene.molecule.reading.beside.empty());
}

TEST_CASE("mistakes with two molecules are reported at their lines") {
  const auto scene = [](const std::string& keys) {
    return errors("## S\n```scene\nmolecule: mix\n" + keys + "```\nText.\n");
  };
  CHECK(scene("beside: shut\n").empty());
  CHECK(scene("beside: shot\n") ==
        Texts{"l.md:12:9: 'shot' is not among the lesson's molecules; did you mean 'shut'?"});
  CHECK(scene("captions: a, b\n") == Texts{"l.md:12:11: 'captions' names two molecules, but the scene has one; add a "
                                           "line 'beside: …' with the second one"});
  CHECK(scene("beside: shut\ncaptions: a\n") ==
        Texts{"l.md:13:11: there are two molecules to name; write two names, as in 'wool, silk'"});
  CHECK(
      scene("beside: shut\nthen: shut\n") ==
      Texts{
          "l.md:13:7: a scene has a second structure or a molecule beside it, not both; take 'then' or 'beside' out"});
  CHECK(scene("forces: all\n").empty());
  CHECK(scene("then: shut\nforces: none\n").empty());
  CHECK(
      scene("then: shut\nforces: electrostatic\n") ==
      Texts{"l.md:13:9: forces act between atoms that rest, and 'then' moves them; write 'forces: none', or leave out "
            "'then'"});
  CHECK(scene("elastic: on\n").empty());
  CHECK(scene("then: shut\nelastic: off\n").empty());
  CHECK(scene("then: shut\nelastic: on\n") ==
        Texts{"l.md:13:10: 'then' and 'elastic' both move the atoms; leave out 'then', or write 'elastic: off'"});
  CHECK(
      scene("forces: all\nelastic: on\n") ==
      Texts{"l.md:13:10: forces act between atoms that rest, and 'elastic' moves them; write 'forces: none', or write "
            "'elastic: off'"});
  CHECK(scene("simulation: mix.xml\n").empty());
  CHECK(scene("simulation: imd://127.0.0.1:8888\n").empty());
  CHECK(scene("simulation: imd://cluster:8888\n") ==
        Texts{"l.md:12:13: \"cluster:8888\" is not a network address; write imd://HOST:PORT with a numeric host"});
  CHECK(scene("then: shut\nsimulation: none\n").empty());
  CHECK(
      scene("then: shut\nsimulation: mix.xml\n") ==
      Texts{"l.md:13:13: 'then' and 'simulation' both move the atoms; leave out 'then', or write 'simulation: none'"});
  CHECK(scene("simulation: mix.xml\nelastic: on\n") ==
        Texts{"l.md:13:10: 'elastic' and 'simulation' both move the atoms; write 'elastic: off', or write 'simulation: "
              "none'"});
  CHECK(scene("simulation: mix.xml\npull: residue\ntemperature: 350\n").empty());
  CHECK(scene("simulation: mix.xml\npull: element C\n").empty());
  CHECK(scene("pull: none\n").empty());
  CHECK(scene("pull: atom\n") ==
        Texts{"l.md:12:7: 'pull' needs a simulation; add a line 'simulation: …', or leave it out"});
  CHECK(scene("temperature: 350\n") ==
        Texts{"l.md:12:14: 'temperature' needs a simulation; add a line 'simulation: …', or leave it out"});
  CHECK(scene("simulation: imd://127.0.0.1:8888\ntemperature: 350\n") ==
        Texts{"l.md:13:14: a simulation in another program has its own heat bath; leave 'temperature' out, and set it "
              "there"});
  CHECK(scene("simulation: mix.xml\ntemperature: 3000\n").size() == 1);
  CHECK(scene("simulation: mix.xml\npull: element Zr\n").size() == 1);
  CHECK(scene("elastic: on\nmodes: 3, 1\n").empty());
  CHECK(scene("elastic: off\nmodes: all\n").empty());
  CHECK(scene("modes: 1\n") ==
        Texts{"l.md:12:8: 'modes' needs an elastic molecule; write 'elastic: on', or leave 'modes' out"});
  CHECK(
      scene("elastic: on\nmodes: 1, 21\n") ==
      Texts{"l.md:13:11: '21' is no motion of an elastic molecule; write numbers from 1 (the softest) to 20, as in '1, "
            "3', or 'all'"});
  // Five nodes have 3 n - 6 = 9 motions.
  CHECK(scene("elastic: on\nmodes: 1, 9\n").empty());
  CHECK(
      scene("elastic: on\nmodes: 1, 10\n") ==
      Texts{"l.md:13:8: the molecule has 9 motions as an elastic network; there is no motion 10; write numbers from 1 "
            "to 9, or leave 'modes' out"});
  // Two residues in the hand leave three nodes, which have none.
  CHECK(scene("elastic: on\nin-hand: residue 4 5\n") ==
        Texts{"l.md:12:10: mix has too few residues for an elastic network: 3; take a molecule of at least 4"});
  CHECK(scene("elastic: on\nmodes: 1,\n").size() == 1);
  CHECK(scene("elastic: on\nmodes: 0\n").size() == 1);
  CHECK(scene("scan: 10 Å\n").empty());
  CHECK(scene("scan: 10 Å, 100 pN\n").empty());
  CHECK(scene("scan: 21 Å\n") == Texts{"l.md:12:7: '21 Å' is no radius of a tip; write a length from 0 to 20 Å"});
  for (const char* force : {"100", "-1 pN", "10001 pN", "1 N", "nan pN"}) {
    CAPTURE(std::string(force));
    CHECK(scene("scan: 10 Å, " + std::string(force) + "\n") ==
          Texts{"l.md:12:13: '" + std::string(force) +
                "' is no force of a tip; write piconewtons from 0 to 10000, as in '100 pN'"});
  }
  CHECK(scene("scan: 10 Å,\n").size() == 1);
  CHECK(scene("scan: 10 Å, 1 pN, 2 pN\n") ==
        Texts{"l.md:12:19: '2 pN' is too much; write the tip's radius, and its force if it has one: '10 Å, 100 pN'"});
  CHECK(scene("then: shut\nscan: 0 Å\n").empty());
  CHECK(scene("then: shut\nscan: 1 nm\n") ==
        Texts{"l.md:13:7: a tip scans atoms at rest, and 'then' moves them; write 'scan: 0 Å', or leave out 'then'"});
  CHECK(scene("scan: 10 Å\nelastic: on\n") ==
        Texts{"l.md:12:7: a tip scans atoms at rest, and 'elastic' moves them; write 'scan: 0 Å', or leave out "
              "'elastic'"});
  CHECK(scene("in-hand: residue 1\nscan: 10 Å\n") ==
        Texts{"l.md:13:7: a scanned surface is touched with a point, and the hand holds a body; write 'scan: 0 Å', or "
              "leave out 'in-hand'"});
  CHECK(scene("simulation: mix.xml\nforces: all\n") ==
        Texts{"l.md:13:9: forces act between atoms that rest, and 'simulation' moves them; write 'forces: none', or "
              "write 'simulation: none'"});
  CHECK(
      scene("then: shut\ntrajectory: md.xtc\n") ==
      Texts{"l.md:13:13: 'then' and 'trajectory' both move the atoms; leave out 'then', or write 'trajectory: none'"});
}
