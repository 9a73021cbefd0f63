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

  /// Until all has been heard, and for so many frames more.
  void frames(int n = 3) {
    while (!queue.empty()) {
      queue.feed(ImGui::GetIO());
      user->frames();
    }
    user->frames(n);
  }
  glm::dvec2 middle(const std::string& widget) const { return widgets().all().at(widget).centre(); }
  glm::dvec2 view() const { return 0.5f * (user->app().layout().view.low + user->app().layout().view.high); }
  Fingers::On on(glm::dvec2 at) const { return fingerOn(user->app(), at); }

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
  CHECK(screen.on(screen.view()) == Fingers::On::View);
  CHECK(screen.on(screen.middle("lesson/next")) == Fingers::On::Panel);
  CHECK(screen.on(screen.middle(kLessonEdge)) == Fingers::On::Edge);
  screen.pointers.fingerDown(1, screen.middle("lesson/next") - glm::dvec2(0, 60), 0.0);
  screen.frames();
  CHECK(screen.on(screen.middle(kHarderPad)) == Fingers::On::Harder);
  CHECK(screen.on(screen.middle(kLighterPad)) == Fingers::On::Lighter);
  // A page over everything is a panel, wherever its finger lies.
  screen.user->app().panels.welcome = true;
  CHECK(screen.on(screen.view()) == Fingers::On::Panel);
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
