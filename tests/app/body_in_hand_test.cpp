// A scene's `in-hand`: its atoms leave the molecule for the hand, which leads and turns them as one body.
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const std::string kHead = "---\ntitle: Mine\nminutes: 5\ngoals: G\nmolecules: 1hpv\nauthor: A\nlicence: L\n---\n";

}  // namespace

TEST_CASE(
    "a scene that holds the drug takes its atoms out of the protein and into the hand; they hover, press and turn as "
    "one "
    "body, and the next step puts them back for the probe") {
  Scratch scratch;
  const auto file = scratch.file("mine.md", kHead +
                                                "## One\n```scene\nmolecule: 1hpv\nin-hand: ligand\n```\nText.\n"
                                                "## Two\n```scene\nin-hand: none\n```\nText.\n");
  auto d = startWith(file.string());
  TouchScene& scene = d->app().scene;
  REQUIRE(scene.stage().body);
  CHECK(scene.stage().body->atoms == scene.stage().balls->untouchable());
  CHECK(*scene.look.hidden == scene.stage().body->atoms);
  CHECK(scene.touch().interaction == "body");
  d->point("view");
  d->frames(30);
  CHECK_FALSE(scene.log().touching());
  const auto save = [&](const char* name) {
    if (const char* to = std::getenv("BODY_PICTURES")) (void)writePng(std::string(to) + name, d->picture());
  };
  save("/hover.png");
  d->press();
  d->frames(60);
  CHECK(scene.log().touching());
  save("/press.png");
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
  save("/turned.png");
  d->app().lesson.next();
  d->frames(30);
  CHECK_FALSE(scene.stage().body);
  CHECK(scene.touch().interaction == "probe");
  CHECK_FALSE(scene.stage().balls->hasUntouchable());
  d->point("view");
  d->press();
  d->frames(60);
  CHECK(scene.log().touching());
  d->release();
  d->app().lesson.back();
  d->frames(20);
  CHECK(scene.stage().body);
  CHECK(scene.touch().interaction == "body");
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

}  // namespace moltact
