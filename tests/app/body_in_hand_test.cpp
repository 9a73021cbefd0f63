// A scene's `in-hand`: the hand removes its atoms from the molecule, moves and rotates them as one rigid body.
#include "tests/app/command_place.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const std::string kBodyInHandHead =
    "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 1hpv\nauthor: A\nlicence: L\n---\n";

}  // namespace

TEST_CASE(
    "a scene that holds the drug takes its atoms out of the protein and into the hand; they hover, press and turn as "
    "one "
    "body, and the next step puts them back for the probe") {
  Scratch scratch;
  const auto file = scratch.file("mine.md", kBodyInHandHead +
                                                "## One\n```scene\nmolecule: 1hpv\nin-hand: ligand\n```\nText.\n"
                                                "## Two\n```scene\nin-hand: none\n```\nText.\n");
  auto d = startWith(file.string());
  HapticSession& scene = d->app().scene;
  REQUIRE(scene.stage().body);
  CHECK(scene.stage().body->atoms == scene.stage().spheres->untouchable());
  CHECK(*scene.look.atoms.hidden == scene.stage().body->atoms);
  CHECK(scene.touch().interaction == "exact-body");
  d->point("view");
  d->frames(30);
  CHECK_FALSE(scene.log().touching());
  d->press();
  d->frames(60);
  CHECK(scene.log().touching());
  const ServoSample pressed = scene.log().latest();
  CHECK(pressed.contact.energy_A2 > 0.0);
  CHECK(pressed.orientation == kNoRotation);
  d->release();
  d->frames(20);
  d->hold("Ctrl");
  d->drag("view", 150, 40, 1);
  d->letGo("Ctrl");
  d->frames(30);
  CHECK(glm::length(rotationBetween(kNoRotation, scene.log().latest().orientation)) > 0.5);
  CHECK_FALSE(scene.log().touching());
  d->app().lesson.next();
  d->frames(30);
  CHECK_FALSE(scene.stage().body);
  CHECK(scene.touch().interaction == "probe");
  CHECK_FALSE(scene.stage().spheres->hasUntouchable());
  d->point("view");
  d->press();
  d->frames(60);
  CHECK(scene.log().touching());
  d->release();
  d->app().lesson.back();
  d->frames(20);
  CHECK(scene.stage().body);
  CHECK(scene.touch().interaction == "exact-body");
  // Another molecule, opened by hand, is touched with the probe.
  d->app().open("1ubq");
  d->app().finishLoading();
  d->frames(20);
  CHECK_FALSE(scene.stage().body);
  CHECK(scene.touch().interaction == "probe");
  d->point("view");
  d->press();
  d->frames(60);
  CHECK(scene.log().touching());
}

TEST_CASE("a scene's key 'hand: springs' gives the body springs; the panel offers both ways, and a choice is undone") {
  Scratch scratch;
  const auto file = scratch.file(
      "mine.md", kBodyInHandHead + "## One\n```scene\nmolecule: 1hpv\nin-hand: ligand\nhand: springs\n```\nText.\n");
  auto d = startWith(file.string());
  HapticSession& scene = d->app().scene;
  REQUIRE(scene.stage().body);
  CHECK(scene.touch().interaction == "springs");
  TouchSetup exact = scene.touch();
  exact.interaction = "exact-body";
  scene.setTouch(exact);
  d->frames(2);
  CHECK(scene.touch() == exact);
  d->tap("Ctrl+Z");
  CHECK(scene.touch().interaction == "springs");
  d->tap("Ctrl+Shift+Z");
  CHECK(scene.touch().interaction == "exact-body");
}

TEST_CASE(
    "a body that several of its atoms hold up is pressed by 0.05 to 0.65 N where a probe would be by 0.6, wherever and "
    "however it is turned") {
  Scratch scratch;
  const auto file =
      scratch.file("mine.md", kBodyInHandHead + "## One\n```scene\nmolecule: 1hpv\nin-hand: ligand\n```\nText.\n");
  auto d = startWith(file.string());
  int several = 0;
  for (int place = 0; place < 12; ++place) {
    d->point("view", 0.40 + 0.03 * place, 0.42 + 0.02 * (place % 4));
    d->frames(30);
    d->press();
    d->frames(200);
    const ServoSample s = d->app().scene.log().latest();
    if (s.contact.touching()) {
      CAPTURE(place);
      CHECK(glm::length(s.force.N) > 0.05);
      CHECK(glm::length(s.force.N) < 0.65);
      several += s.contact.atoms[1] >= 0;
    }
    d->release();
    d->frames(30);
    d->hold("Ctrl");
    d->drag("view", 60, 25, 1);
    d->letGo("Ctrl");
  }
  CHECK(several >= 2);
}

TEST_CASE(
    "a lesson whose held body has more than 5000 atoms, or none that exist, is reported and touched with the probe") {
  Scratch scratch;
  for (const char* atoms : {"protein", "resname ZZZ"}) {
    CAPTURE(atoms);
    const auto file =
        scratch.file("mine.md",
                     "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 2por\nauthor: A\nlicence: L\n---\n"
                     "## One\n```scene\nmolecule: 2por\nassembly: 1\nin-hand: " +
                         std::string(atoms) + "\n```\nText.\n");
    auto d = startWith(file.string());
    CHECK_FALSE(d->app().scene.stage().body);
    CHECK(d->app().scene.touch().interaction == "probe");
    const auto& reported = d->app().messages.all();
    CHECK(std::any_of(reported.begin(), reported.end(), [](const auto& m) {
            return contains(m.text, "atoms are more than a hand can hold; 5000 are the most");
          }) == (atoms[0] == 'p'));
    CHECK(std::any_of(reported.begin(), reported.end(), [](const auto& m) {
            return contains(m.text, "mine.md:13:18: the hand holds nothing: ") && contains(m.text, "ZZZ");
          }) == (atoms[0] == 'r'));
    const test::Run play = test::CommandPlace().run("play '" + file.string() + "' --demonstrate");
    CHECK(play.status == 0);
  }
}

}  // namespace moltact
