// The mouse pointer and the probe, through the window on the frames' clock: their places in the picture while the probe
// is pressed, dragged and released, and the force meanwhile.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include "engine/servo/plain_trackers.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

glm::dvec2 pointer_px(ScriptedUser& d) {
  const Rectangle& view = d.app().layout().view;
  return {double(ImGui::GetIO().MousePos.x - view.low.x), double(ImGui::GetIO().MousePos.y - view.low.y)};
}

glm::dvec2 seen_px(ScriptedUser& d, PointA at) {
  const glm::dvec2 size = d.app().layout().view.size();
  const Vec3 px = d.app().scene.camera.project(at, int(size.x), int(size.y));
  return {px.x, px.y};
}

glm::dvec2 probe_px(ScriptedUser& d) {
  const ServoSample& now = d.app().scene.log().latest();
  return seen_px(d, now.contact.touching() ? now.contact.scp : now.hip);
}

double apart_px(ScriptedUser& d) { return glm::distance(pointer_px(d), probe_px(d)); }

// The greatest of the last 30 to 50 ticks, which are those of the last frame and some before it.
double greatest_N(ScriptedUser& d) {
  const PlotBuffer& force = d.app().scene.log().force();
  double most = d.app().scene.log().force_N();
  for (std::size_t k = 0; k < 4 && k < force.size(); ++k) most = std::max(most, double(force.ago(k)));
  return most;
}

// Moves the pointer at constant speed in this number of frames and calls a function after each.
template <typename Each>
void moveBy(ScriptedUser& d, glm::dvec2 way_px, int frames, const Each& each) {
  const glm::dvec2 from = pointer_px(d), size = d.app().layout().view.size();
  for (int k = 1; k <= frames; ++k) {
    const glm::dvec2 to = (from + way_px * (double(k) / frames)) / size;
    d.point("view", to.x, to.y);
    each();
  }
}

// Once in 300 ticks it takes longer over one than the loop bears.
class StallingPull final : public PlainTracker {
 public:
  Contact step(PointA hip) noexcept override {
    if (++ticks_ % 300 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(30));
    return pull_.step(hip);
  }

 private:
  ConstantForceTracker pull_{1.0};
  int ticks_ = 0;
};

}  // namespace

TEST_CASE(
    "a pressed probe goes with the pointer: dragged by 220 px within 0.7 s it is never farther than 30 px from it, and "
    "within 8 px where it rests, harder pushes or not") {
  for (const double notches : {0.0, 4.0}) {
    CAPTURE(notches);
    auto d = startWith("1ubq");
    d->point("view", 0.4, 0.5);
    d->press();
    d->frames(60);
    if (notches > 0.0) d->wheel(notches);
    d->frames(60);
    CHECK(apart_px(*d) < 8.0);
    const glm::dvec2 before = probe_px(*d);
    double farthest_px = 0.0;
    moveBy(*d, {220.0, 0.0}, 42, [&] { farthest_px = std::max(farthest_px, apart_px(*d)); });
    CHECK(farthest_px < 30.0);
    d->frames(30);
    CHECK(apart_px(*d) < 8.0);
    CHECK(probe_px(*d).x - before.x == doctest::Approx(220.0).epsilon(0.05));
  }
}

TEST_CASE("a pointer that presses in the frame in which it arrives has the probe under it, not where it hovered") {
  auto d = startWith("1ubq");
  d->point("view", 0.6, 0.4);
  d->press();
  d->frames(60);
  CHECK(apart_px(*d) < 8.0);
}

TEST_CASE("a release where the pointer rests moves the probe by less than 12 px, and the pointer by none") {
  auto d = startWith("1ubq");
  for (const double x : {0.35, 0.45, 0.55, 0.65}) {
    CAPTURE(x);
    d->point("view", x, 0.5);
    d->press();
    d->frames(60);
    d->wheel(3);
    d->frames(30);
    const glm::dvec2 pointer = pointer_px(*d), probe = probe_px(*d);
    d->release();
    double farthest_px = 0.0;
    for (int k = 0; k < 40; ++k) {
      d->frames(1);
      farthest_px = std::max(farthest_px, glm::distance(probe, probe_px(*d)));
    }
    CHECK(farthest_px < 12.0);
    CHECK(pointer_px(*d) == pointer);
    CHECK(apart_px(*d) < 1.0);
    CHECK(d->app().scene.log().force_N() == 0.0);
  }
}

TEST_CASE(
    "whatever way a press took, no tick after the release has more force than one before it; and on no way does a rest "
    "of 0.6 N and 0.2 N a notch grow by more than 0.8 N") {
  constexpr unsigned kSeed = 20261123;
  CAPTURE(kSeed);
  std::mt19937 random(kSeed);
  const auto any = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  auto d = startWith("1ubq");
  int felt = 0;
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    d->point("view", any(0.25, 0.75), any(0.2, 0.8));
    d->frames(int(any(1, 20)));
    d->press();
    d->frames(int(any(2, 60)));
    const int notches = int(any(0, 6));
    if (notches > 0) d->wheel(notches);
    d->frames(10);
    double before_N = greatest_N(*d);
    moveBy(*d, {any(-250, 250), any(-250, 250)}, int(any(2, 60)),
           [&] { before_N = std::max(before_N, greatest_N(*d)); });
    d->release();
    // The ticks of a frame come before its input is read: these still followed the press.
    before_N = std::max(before_N, greatest_N(*d));
    double after_N = 0.0;
    for (int k = 0; k < 40; ++k) {
      d->frames(1);
      after_N = std::max(after_N, greatest_N(*d));
    }
    CHECK(after_N <= before_N + 1e-6);
    CHECK(before_N < 0.6 + 0.2 * notches + 0.8);
    CHECK(d->app().scene.log().force_N() == 0.0);
    felt += before_N > 0.3;
  }
  CHECK(felt > 20);
}

TEST_CASE(
    "a press beside the molecule says that there is nothing, where the pointer is, and one on the molecule does not") {
  auto d = startWith("1ubq");
  d->point("view", 0.08, 0.2);
  d->frames(30);
  CHECK_FALSE(d->shows("view/nothing here"));
  d->press();
  d->frames(30);
  REQUIRE(d->shows("view/nothing here"));
  CHECK(contains(d->text("view/nothing here"), "nothing under the pointer"));
  const WidgetRecord& reported = *widgets().find("view/nothing here");
  const Rectangle& view = d->app().layout().view;
  CHECK(reported.low.x >= view.low.x);
  CHECK(reported.high.y <= view.high.y);
  CHECK(double(reported.low.y) - double(view.low.y) - pointer_px(*d).y < 60.0);
  // The same press, brought over the molecule, feels it and says nothing of the kind.
  moveBy(*d, {0.42 * double(view.size().x), 0.3 * double(view.size().y)}, 40, [] {});
  d->frames(60);
  CHECK(d->app().scene.log().touching());
  CHECK_FALSE(d->shows("view/nothing here"));
  d->release();
  d->point("view", 0.08, 0.2);
  d->frames(30);
  CHECK_FALSE(d->shows("view/nothing here"));
}

TEST_CASE("a press that rests shows how to push harder, until that has been done once") {
  auto d = startWith("1ubq");
  d->point("view");
  d->press();
  d->frames(30);
  CHECK_FALSE(d->shows("view/push hint"));
  d->frames(90);
  REQUIRE(d->shows("view/push hint"));
  CHECK(contains(d->text("view/push hint"), "press +"));
  const double before_N = d->app().scene.log().force_N();
  d->tap("plus");
  d->frames(30);
  CHECK(d->app().scene.log().force_N() > before_N + 0.1);
  CHECK_FALSE(d->shows("view/push hint"));
  d->release();
  d->frames(30);
  d->press();
  d->frames(120);
  CHECK_FALSE(d->shows("view/push hint"));
}

TEST_CASE("a press that slides does not show how to push harder: the words would cover its path") {
  auto d = startWith("1ubq");
  d->point("view", 0.4, 0.5);
  d->press();
  bool reported = false;
  moveBy(*d, {120.0, 0.0}, 120, [&] { reported = reported || d->shows("view/push hint"); });
  CHECK_FALSE(reported);
  d->frames(90);
  CHECK(d->shows("view/push hint"));
}

TEST_CASE("a task that needs more force than the hand gives shows how to push harder, every time") {
  const Scratch scratch;
  auto d = startWith("");
  d->app().open(scratch.file("harder.md", R"(---
title: Harder
minutes: 1
goals:
  - Push
molecules:
  - argon-pair
author: A test
licence: MIT
---

## Push

Push.

```scene
molecule: argon-pair
probe: 1.4 Å
```

```touch
press: anywhere
until: 1.2 N
say: Push.
```
)"));
  d->app().finishLoading();
  d->frames(20);
  REQUIRE(d->app().lesson.session());
  const auto rests = [&] {
    for (int k = 0; k < 4 && !d->app().scene.log().touching(); ++k) {
      d->release();
      d->frames(30);
      const Vec3 sphere = d->app().scene.stage().spheres->spheres()[std::size_t(k % 2)].centre_A;
      const glm::dvec2 at = seen_px(*d, {sphere}) / glm::dvec2(d->app().layout().view.size());
      d->point("view", at.x, at.y);
      d->frames(20);
      d->press();
      d->frames(120);
    }
    REQUIRE(d->app().scene.log().touching());
  };
  rests();
  CHECK(d->shows("view/push hint"));
  d->wheel(1);
  d->frames(20);
  CHECK(d->shows("view/push hint"));
  // Two fingers on a trackpad come as parts of a notch.
  for (int k = 0; k < 40; ++k) d->wheel(0.1);
  d->frames(40);
  CHECK(d->app().lesson.session()->taskAt(0)->done());
  CHECK_FALSE(d->shows("view/push hint"));
}

TEST_CASE("ten tenths of a notch, as a trackpad gives them, push as deep as one notch of a wheel") {
  auto d = startWith("1ubq");
  const auto depthAfter_A = [&](int parts) {
    d->point("view");
    d->press();
    d->frames(90);
    const double before_A = d->app().scene.controls.depth_A();
    for (int k = 0; k < parts; ++k) d->wheel(1.0 / parts);
    d->frames(30);
    const double way_A = d->app().scene.controls.depth_A() - before_A;
    d->release();
    d->frames(30);
    return way_A;
  };
  const double whole_A = depthAfter_A(1);
  CHECK(whole_A > 0.05);
  CHECK(depthAfter_A(10) == doctest::Approx(whole_A).epsilon(1e-3));
}

TEST_CASE("where the computer is late the shown force falls, and the screen says so while the mouse pushes") {
  ScriptedUser::Options options;
  options.application.clock = ServoClock::RealThread;
  auto d = startWith("argon-pair", options);
  d->app().scene.servo().setInteraction(std::make_unique<StallingPull>());
  const auto reported = [&](int frames) {
    bool out = false;
    for (int k = 0; k < frames && !out; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      d->frames(1);
      out = contains(d->text("limits"), "computer was late");
    }
    return out;
  };
  // A hand that does not push misses nothing.
  CHECK_FALSE(reported(200));
  d->point("view");
  d->press();
  CHECK(reported(4000));
  d->release();
  d->frames(2);
  CHECK_FALSE(d->shows("limits"));
}

}  // namespace moltact
