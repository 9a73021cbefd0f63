// Magnifying a part of the molecule, by the user and by a lesson, with its indication on the screen.
#include "engine/device/simulated_device.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const char* kMagnifyLesson = R"(---
title: Magnified
minutes: 5
goals: Feel a part larger.
molecules: 1ubq
author: A
licence: CC0
---

## Whole

```scene
molecule: 1ubq
```

All of it.

## Part

```scene
view: facing residue 44
magnify: residue 44
```

Isoleucine 44.

## Whole again

```scene
magnify: none
locked: magnify
```

All of it.
)";

double scale(ScriptedUser& d) { return d.app().scene.servo_settings.workspace.A_per_mm; }

// Where the probe is in the picture (unit: pixel of the view).
glm::dvec2 probePixel(ScriptedUser& d) {
  const auto size = d.app().layout().view.size();
  const Vec3 px = d.app().scene.camera.project(d.app().scene.log().latest().hip, int(size.x), int(size.y));
  return {px.x, px.y};
}

}  // namespace

TEST_CASE(
    "Ctrl+G magnifies round the probe: 0.25 A a mm becomes 0.1, hand and probe stay, the picture grows as much about "
    "it; again, and all is as before") {
  auto d = startWith();
  d->point("view", 0.55, 0.45);
  d->frames(30);
  CHECK_FALSE(d->shows("status/scale"));
  const Camera camera = d->app().scene.camera;
  const double whole = scale(*d);
  const ServoSample before = d->app().scene.log().latest();
  const glm::dvec2 pixel = probePixel(*d);
  d->tap("Ctrl+G");
  d->frames(30);
  CHECK(scale(*d) == doctest::Approx(0.1));
  CHECK(contains(d->text("status/scale"),
                 "1\u00a0mm here is 0.1\u00a0Å there, 1\u00a0N here would be 18\u00a0pN there, magnified 2.5 times"));
  CHECK(d->app().scene.camera.distance_A == doctest::Approx(camera.distance_A * scale(*d) / whole));
  const ServoSample after = d->app().scene.log().latest();
  CHECK(glm::distance(after.hip.A, before.hip.A) < 0.05);
  CHECK(glm::distance(after.hand.mm, before.hand.mm) < 0.5);
  CHECK(glm::distance(probePixel(*d), pixel) < 3.0);
  d->tap("Ctrl+G");
  d->frames(30);
  CHECK(scale(*d) == doctest::Approx(0.25).epsilon(0.01));
  CHECK_FALSE(d->shows("status/scale"));
  CHECK(glm::distance(d->app().scene.camera.target.A, camera.target.A) < 0.2);
}

TEST_CASE("magnified in the middle of a press the contact stays, and the force grows again from nothing") {
  auto d = startWith();
  d->point("view");
  d->press();
  for (int k = 0; k < 200 && d->app().scene.log().force_N() < 0.3; ++k) d->frames(1);
  REQUIRE(d->app().scene.log().force_N() >= 0.3);
  d->tap("Ctrl+G");
  CHECK(scale(*d) == doctest::Approx(0.1));
  CHECK(d->app().scene.log().touching());
  double least = 9;
  for (int k = 0; k < 3; ++k) d->frames(1), least = std::min(least, d->app().scene.log().force_N());
  CHECK(least < 0.5);
  CHECK(d->app().scene.log().touching());
  d->release();
}

TEST_CASE("the view's Home ends what was magnified by hand") {
  auto d = startWith();
  d->point("view");
  d->frames(10);
  d->tap("Ctrl+G");
  CHECK(scale(*d) == doctest::Approx(0.1));
  d->tap("Home");
  CHECK(scale(*d) == doctest::Approx(0.25).epsilon(0.01));
}

TEST_CASE("what was magnified by hand is undone and redone, and so is its end by Home") {
  auto d = startWith();
  d->point("view");
  d->frames(10);
  const double whole = scale(*d);
  d->tap("Ctrl+G");
  d->frames(3);
  CHECK(d->click("tool/undo"));
  d->frames(3);
  CHECK(scale(*d) == doctest::Approx(whole));
  CHECK_FALSE(d->app().scene.view().fit.by_hand);
  CHECK(d->click("tool/redo"));
  d->frames(3);
  CHECK(scale(*d) == doctest::Approx(0.1));
  const Camera near = d->app().scene.camera;
  d->tap("Home");
  d->frames(60);
  CHECK(scale(*d) == doctest::Approx(whole));
  CHECK(d->click("tool/undo"));
  d->frames(60);
  CHECK(scale(*d) == doctest::Approx(0.1));
  CHECK(d->app().scene.camera.distance_A == doctest::Approx(near.distance_A));
}

TEST_CASE(
    "a device with another room is chosen while residue 44 is magnified: it fills that room, and the force begins at "
    "nothing") {
  const Scratch scratch;
  auto d = startWith("");
  d->app().open(scratch.file("magnified.md", kMagnifyLesson));
  d->app().finishLoading();
  d->frames(10);
  d->app().lesson.next();
  d->frames(10);
  const double radius_A = d->app().lesson.region()->radius_A;
  CHECK(scale(*d) == doctest::Approx(radius_A / 35.0));
  d->tap("Ctrl+D");
  d->frames(3);
  REQUIRE(d->click("device/simulated"));
  d->frames(3);
  const Vec3 room = d->app().scene.servo().device().workspace_mm;
  CHECK(scale(*d) == doctest::Approx(2 * radius_A / std::min({room.x, room.y, room.z})));
  // Its middle lies straight behind the middle of the room, and the hand begins free before it.
  const Vec3 off = d->app().lesson.region()->centre.A - d->app().scene.servo_settings.workspace.centre_A,
             back = d->app().scene.camera.back();
  CHECK(glm::length(off - back * glm::dot(off, back)) < 1e-9);
  CHECK(glm::dot(off, back) < 0.0);
  CHECK(d->app().scene.log().force_N() < 0.05);
}

TEST_CASE(
    "a lesson's step magnifies residue 44 so that it fills the hand's room and the view, and the next step ends it") {
  const Scratch scratch;
  auto d = startWith("");
  d->app().open(scratch.file("magnified.md", kMagnifyLesson));
  d->app().finishLoading();
  d->frames(10);
  CHECK(scale(*d) == doctest::Approx(0.25).epsilon(0.01));
  const double far_A = d->app().scene.camera.distance_A;
  d->app().lesson.next();
  d->frames(10);
  const std::optional<Region> region = d->app().lesson.region();
  REQUIRE(region);
  CHECK(scale(*d) == doctest::Approx(region->radius_A / 35.0));  // half of the narrowest side of the room
  CHECK(scale(*d) < 0.2);
  CHECK(contains(d->text("status/scale"), "magnified"));
  CHECK(d->app().scene.camera.distance_A < 0.6 * far_A);
  CHECK(glm::distance(d->app().scene.camera.target.A, region->centre.A) < 1e-9);
  // By hand it continues from there, and back to there.
  const double by_lesson = scale(*d);
  d->tap("Ctrl+G");
  CHECK(scale(*d) <= 0.5 * by_lesson + 1e-12);
  d->tap("Ctrl+G");
  CHECK(scale(*d) == doctest::Approx(by_lesson));
  d->app().lesson.next();
  d->frames(10);
  CHECK(scale(*d) == doctest::Approx(0.25).epsilon(0.01));
  d->tap("Ctrl+G");  // locked here
  CHECK(scale(*d) == doctest::Approx(0.25).epsilon(0.01));
}

TEST_CASE("with a stylus the scale is always shown, and a magnified part fills the stylus's workspace") {
  auto d = startWith();
  d->tap("Ctrl+D");
  d->frames(3);
  REQUIRE(d->click("device/simulated"));
  d->tap("Escape");
  d->frames(3);
  CHECK(d->text("status/scale") == "1\u00a0mm here is 0.25\u00a0Å there, 1\u00a0N here would be 130\u00a0pN there");
  const double half_mm = 0.5 * d->app().scene.servo().device().workspace_mm.x;
  d->tap("Ctrl+G");
  d->frames(3);
  CHECK(scale(*d) == doctest::Approx(std::min(3.5 / half_mm, 0.125)));
}

}  // namespace moltact
