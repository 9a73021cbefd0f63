// Transitions between scenes, on the frames' clock: a frame is 1/60 s.
#include "app/ui/extensions/scene_change.h"

#include "app/ui/extensions/extensions.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

double turn_rad(const Camera& a, const Camera& b) {
  return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a.orientation, b.orientation))));
}

}  // namespace

TEST_CASE(
    "between two cameras a quarter turn apart the half is an eighth turn, the middle of the targets, the mean distance "
    "by factors") {
  Camera a, b;
  b.target.A = Vec3(4, 0, 0);
  b.distance_A = 90;
  b.orientation = glm::angleAxis(1.5707963267949, Vec3(0, 1, 0));
  a.distance_A = 40;
  const Camera half = between(a, b, 0.5);
  CHECK(half.target.A.x == doctest::Approx(2));
  CHECK(half.distance_A == doctest::Approx(60));
  CHECK(turn_rad(a, half) == doctest::Approx(0.7853981633974));
  CHECK(between(a, b, 0) == a);
  CHECK(turn_rad(between(a, b, 1), b) < 1e-6);
}

TEST_CASE(
    "a scene that begins again glides the camera back in 0.6 s without a jump; with reduced motion it is there at "
    "once") {
  for (const bool reduced : {false, true}) {
    auto d = startWith("1ubq");
    Application& app = d->app();
    app.settings.reduced_motion = reduced;
    const Camera home = app.scene.camera;
    app.scene.camera.orbit(1.0, 0.3);
    app.scene.camera.zoom(2.0);
    d->frames(2);
    const Camera away = app.scene.camera;
    REQUIRE(turn_rad(home, away) > 0.5);
    app.scene.view().beginAgain([](Camera&, const Molecule&) {});
    app.extensions().scene_change.sceneChanged();
    d->frames(1);
    if (reduced) {
      CHECK(turn_rad(app.scene.camera, home) < 1e-9);
      continue;
    }
    CHECK(turn_rad(app.scene.camera, away) < 0.1);
    double fastest = 0;
    Camera before = app.scene.camera;
    for (int frame = 0; frame < 40; ++frame) {
      d->frames(1);
      fastest = std::max(fastest, turn_rad(before, app.scene.camera));
      before = app.scene.camera;
    }
    CHECK(fastest < 0.08);  // 1 rad in 36 frames, one and a half times the mean at most
    CHECK(turn_rad(app.scene.camera, home) < 1e-6);
    CHECK(app.scene.camera.distance_A == doctest::Approx(home.distance_A));
  }
}

TEST_CASE(
    "Home glides for 0.6 s and ends where it would have jumped to; pressed again on its way it is one way, and undo "
    "glides back") {
  auto d = startWith("1ubq");
  Application& app = d->app();
  app.settings.reduced_motion = false;
  const Camera home = app.scene.camera;
  d->drag("view", 90, 20, 1);
  const Camera away = app.scene.camera;
  REQUIRE(turn_rad(home, away) > 0.5);
  d->tap("Home");
  CHECK(turn_rad(app.scene.camera, away) < 0.1);
  d->frames(10);
  d->tap("Home");
  d->frames(40);
  CHECK(turn_rad(app.scene.camera, home) < 1e-6);
  CHECK_FALSE(app.extensions().scene_change.gliding());
  d->tap("Ctrl+Z");
  CHECK(turn_rad(app.scene.camera, home) < 0.1);
  d->frames(40);
  CHECK(turn_rad(app.scene.camera, away) < 1e-6);
  CHECK_FALSE(app.extensions().history.canUndo());
}

TEST_CASE("another molecule fades in over 0.35 s: the first frame is mostly the old picture, the last all new") {
  auto d = startWith("argon-pair");
  d->app().settings.reduced_motion = false;
  d->frames(30);
  const Picture old = d->picture();
  d->app().open("benzene");
  d->frames(1);
  CHECK(d->app().extensions().scene_change.oldPicture() > 0.8);
  // The middle of the view, between the two argon spheres and on benzene's ring.
  const WidgetRecord view = *widgets().find("view");
  const auto at = [&](const Picture& p, float x, float y) {
    const glm::vec2 q = glm::mix(view.low, view.high, glm::vec2(x, y));
    const std::uint8_t* c = p.at(int(q.x), int(q.y));
    return glm::vec3(c[0], c[1], c[2]);
  };
  const Picture first = d->picture();
  d->frames(60);
  const Picture last = d->picture();
  CHECK(d->app().extensions().scene_change.oldPicture() == 0.0);
  const float x = 0.3f, y = 0.5f;  // on the left argon
  REQUIRE(glm::distance(at(old, x, y), at(last, x, y)) > 30.0f);
  CHECK(glm::distance(at(first, x, y), at(old, x, y)) < 0.35f * glm::distance(at(old, x, y), at(last, x, y)));
}

TEST_CASE(
    "a scene is fitted to the view that its own panels leave, whichever the scene before it had: going on or back, "
    "resetting the view changes nothing") {
  const std::string head =
      "---\ntitle: Panels\nminutes: 1\ngoals:\n  - g\nmolecules:\n  - 1ubq\n  - benzene\nauthor: T\nlicence: "
      "CC0-1.0\n---\n\n";
  const auto step = [](const std::string& name, const std::string& molecule, const std::string& panels) {
    return "## " + name + "\n\n```scene\nmolecule: " + molecule + "\npanels: " + panels + "\n```\n\nText.\n\n";
  };
  Scratch scratch;
  auto d = startWith(scratch
                         .file("panels.md", head + step("One", "1ubq", "touch") + step("Two", "1ubq", "none") +
                                                step("Three", "1ubq", "touch") + step("Four", "benzene", "none") +
                                                step("Five", "1ubq", "touch"))
                         .string());
  Application& app = d->app();
  const auto fitted = [&] {
    app.finishLoading();
    d->frames(5);
    const Camera seen = app.scene.camera;
    app.resetView();
    CHECK(app.scene.camera.distance_A == doctest::Approx(seen.distance_A));
    CHECK(glm::distance(app.scene.camera.target.A, seen.target.A) < 1e-9);
    return seen.distance_A;
  };
  const double narrow = fitted();
  app.lesson.next();
  d->frames(1);
  CHECK(fitted() < narrow);  // the view is wider than high: the molecule fills it sooner
  for (int k = 0; k < 3; ++k) {
    app.lesson.next();
    d->frames(1);
    fitted();
  }
  CHECK(fitted() == doctest::Approx(narrow));
  for (int k = 0; k < 4; ++k) {
    app.lesson.back();
    d->frames(1);
    fitted();
  }
}

}  // namespace moltact
