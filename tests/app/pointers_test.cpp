// Fingers on the parts of the window: which rule applies where, and its effect.
#include "app/ui/shell/pointers.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/panels/push_pads.h"
#include "app/ui/panels/splitters.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// A touch screen in front of the window.
struct Screen {
  explicit Screen(const std::string& what = "1ubq") : user(startWith(what)), pointers(user->app(), queue) {}

  /// Runs until all input has been processed, and for this number of further frames.
  void frames(int n = 3) {
    while (!queue.empty()) {
      queue.feed(ImGui::GetIO());
      user->frames();
    }
    user->frames(n);
  }
  glm::dvec2 middle(const std::string& widget) const { return widgets().all().at(widget).centre(); }
  glm::dvec2 view() const { return 0.5f * (user->app().layout().view.low + user->app().layout().view.high); }
  Fingers::Target on(glm::dvec2 at) const { return fingerOn(user->app(), at); }

  std::unique_ptr<ScriptedUser> user;
  InputQueue queue;
  Pointers pointers;
};

double turnedBy_deg(const Quat& a, const Quat& b) {
  return glm::degrees(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))));
}

}  // namespace

TEST_CASE("a finger touches one of five parts: the view, a panel, the edge between them, the pads + and -") {
  Screen screen(std::string(MOLTACT_SOURCE_DIR) + "/lessons/first-touch.md");
  CHECK(screen.on(screen.view()) == Fingers::Target::View);
  CHECK(screen.on(screen.middle("lesson/next")) == Fingers::Target::Panel);
  CHECK(screen.on(screen.middle(kLessonEdge)) == Fingers::Target::Edge);
  screen.pointers.fingerDown(1, screen.middle("lesson/next") - glm::dvec2(0, 60), 0.0);
  screen.frames();
  CHECK(screen.on(screen.middle(kHarderPad)) == Fingers::Target::Harder);
  CHECK(screen.on(screen.middle(kLighterPad)) == Fingers::Target::Lighter);
  // A page over the window counts as a panel everywhere.
  screen.user->app().panels.pages.welcome = true;
  CHECK(screen.on(screen.view()) == Fingers::Target::Panel);
}

TEST_CASE(
    "a finger on the molecule presses and the pads come; two turn it by their way alone, pressing nothing; a mouse "
    "that moves takes the pads away") {
  Screen screen;
  Application& app = screen.user->app();
  CHECK_FALSE(screen.user->shows(kHarderPad));
  CHECK_FALSE(screen.pointers.anyFinger());
  screen.pointers.fingerDown(1, screen.view(), 0.0);
  screen.frames(60);
  CHECK(screen.pointers.anyFinger());
  CHECK(app.scene.controls.pressing());
  CHECK(app.scene.log().touching());
  CHECK(screen.user->shows(kHarderPad));

  const Quat before = app.scene.camera.orientation;
  screen.pointers.fingerDown(2, screen.view() + glm::dvec2(100, 0), 1.0);
  screen.frames();
  CHECK_FALSE(app.scene.controls.pressing());
  CHECK(turnedBy_deg(app.scene.camera.orientation, before) < 0.01);  // their middle lies 50 pixels beside the first
  screen.pointers.fingerMove(1, screen.view() + glm::dvec2(90, 0));
  screen.pointers.fingerMove(2, screen.view() + glm::dvec2(190, 0));
  screen.frames();
  CHECK(turnedBy_deg(app.scene.camera.orientation, before) > 5.0);
  CHECK_FALSE(app.scene.controls.pressing());
  screen.pointers.fingerUp(1);
  CHECK(screen.pointers.anyFinger());
  screen.pointers.fingerUp(2);
  CHECK_FALSE(screen.pointers.anyFinger());
  screen.frames();

  screen.pointers.mouse(screen.view());
  screen.frames();
  CHECK_FALSE(screen.user->shows(kHarderPad));
}

TEST_CASE(
    "with a body in the hand two fingers turn it, by their way and their twist, and the view stays; three turn the "
    "view, "
    "and the body stays") {
  Scratch scratch;
  const auto file = scratch.file("mine.md",
                                 "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 1hpv\nauthor: A\nlicence: L\n---\n"
                                 "## One\n```scene\nmolecule: 1hpv\nin-hand: ligand\n```\nText.\n");
  Screen screen(file.string());
  Application& app = screen.user->app();
  REQUIRE(app.scene.stage().body);
  const auto held = [&] { return app.scene.log().latest().orientation; };
  const auto turnOf = [&](const Quat& from) { return rotationBetween(from, held()); };
  const Quat view = app.scene.camera.orientation, begun = held();

  // A twist of 40 degrees clockwise, with the middle where it is.
  const auto at = [&](double deg) {
    return screen.view() + 100.0 * glm::dvec2(std::cos(glm::radians(deg)), std::sin(glm::radians(deg)));
  };
  screen.pointers.fingerDown(1, at(180), 0.0);
  screen.pointers.fingerDown(2, at(0), 0.1);
  screen.frames();
  for (int k = 1; k <= 40; ++k) {
    screen.pointers.fingerMove(1, at(180 + k));
    screen.pointers.fingerMove(2, at(k));
    screen.frames(1);
  }
  screen.frames(20);
  const Vec3 rolled = turnOf(begun);
  CHECK(glm::degrees(glm::length(rolled)) == doctest::Approx(40.0).epsilon(0.05));
  CHECK(glm::dot(glm::normalize(rolled), app.scene.camera.back()) < -0.99);
  CHECK(app.scene.camera.orientation == view);

  // Their way tilts it: to the right round the upright axis of the screen.
  const Quat before = held();
  for (int k = 1; k <= 60; ++k) {
    screen.pointers.fingerMove(1, at(220) + glm::dvec2(k, 0));
    screen.pointers.fingerMove(2, at(40) + glm::dvec2(k, 0));
    screen.frames(1);
  }
  screen.frames(20);
  CHECK(glm::degrees(glm::length(turnOf(before))) > 5.0);
  CHECK(glm::dot(glm::normalize(turnOf(before)), app.scene.camera.up()) > 0.95);
  CHECK(app.scene.camera.orientation == view);

  const Quat tilted = held();
  screen.pointers.fingerDown(3, screen.view() + glm::dvec2(0, 80), 3.0);
  screen.frames(20);
  CHECK(turnedBy_deg(held(), tilted) < 1e-3);
  for (int k = 1; k <= 60; ++k) {
    screen.pointers.fingerMove(3, screen.view() + glm::dvec2(3 * k, 80));
    screen.frames(1);
  }
  screen.frames(20);
  CHECK(turnedBy_deg(app.scene.camera.orientation, view) > 5.0);
  CHECK(turnedBy_deg(held(), tilted) < 1e-3);
}

TEST_CASE("one finger presses and two turn for those too who have given the mouse's two buttons each other's work") {
  Screen screen;
  Application& app = screen.user->app();
  app.settings.left_handed = true;
  screen.pointers.fingerDown(1, screen.view(), 0.0);
  screen.frames();
  CHECK(app.scene.controls.pressing());
  const Quat before = app.scene.camera.orientation;
  screen.pointers.fingerDown(2, screen.view() + glm::dvec2(100, 0), 1.0);
  screen.frames();
  screen.pointers.fingerMove(1, screen.view() + glm::dvec2(90, 0));
  screen.frames();
  CHECK_FALSE(app.scene.controls.pressing());
  CHECK(turnedBy_deg(app.scene.camera.orientation, before) > 5.0);
}

}  // namespace moltact
