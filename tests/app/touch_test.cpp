// Touching through the window, on the frames' clock.
#include <chrono>
#include <thread>

#include "engine/haptics/methods.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

double notch_A(ScriptedUser& d) {
  const ServoSettings& s = d.app().scene.servo_settings;
  return PointerHand::kNotch_N / (s.stiffness_N_per_mm / s.workspace.A_per_mm);
}

}  // namespace

TEST_CASE(
    "pressing on the protein for 2 s gives a force of 0.6 N or less at a slant, and the status bar says touching") {
  auto d = startWith();
  REQUIRE(d->point("view"));
  CHECK(d->text("status/contact") == "free");
  d->press();
  d->frames(120);
  CHECK(d->text("status/contact") == "touching");
  CHECK(d->app().scene.log().force_N() > 0.3);
  CHECK(d->app().scene.log().force_N() < 0.61);
  CHECK(contains(d->text("view/state"), "touching: "));
  d->release();
  d->frames(30);
  CHECK(d->text("status/contact") == "free");
  CHECK(d->app().scene.log().force_N() == 0.0);
}

TEST_CASE("the wheel while pressing pushes deeper and leaves the camera alone; without a press it zooms") {
  auto d = startWith();
  d->point("view");
  d->press();
  d->frames(30);
  const double depth_A = d->app().scene.controls.depth_A(), distance_A = d->app().scene.camera.distance_A;
  d->wheel(4);
  CHECK(d->app().scene.controls.depth_A() - depth_A > 4 * notch_A(*d) * 0.99);
  CHECK(d->app().scene.camera.distance_A == distance_A);
  d->release();
  d->wheel(1);
  CHECK(d->app().scene.camera.distance_A < distance_A);
}

TEST_CASE("keyboard alone: arrows and space reach a contact, plus pushes deeper, escape lets go") {
  auto d = startWith();
  d->hold("Right");
  d->frames(12);
  d->letGo("Right");
  CHECK(d->text("status/contact") == "free");
  d->hold("Space");
  d->frames(60);
  CHECK(d->text("status/contact") == "touching");
  const double depth_A = d->app().scene.controls.depth_A();
  d->tap("plus");
  CHECK(d->app().scene.controls.depth_A() > depth_A + 0.9 * notch_A(*d));
  d->tap("Escape");
  d->frames(30);
  CHECK(d->text("status/contact") == "free");
  d->letGo("Space");
}

TEST_CASE("a tap of three keys within one frame is seen three times") {
  auto d = startWith();
  d->hold("Space");
  d->frames(30);
  const double before_A = d->app().scene.controls.depth_A();
  d->tap("plus");
  d->tap("plus");
  d->tap("plus");
  CHECK(d->app().scene.controls.depth_A() > before_A + 2.9 * notch_A(*d));
}

TEST_CASE("a right drag turns the view, ctrl and arrows too, shift and arrows move it, and Home brings it back") {
  auto d = startWith();
  const Camera home = d->app().scene.camera;
  d->drag("view", 120, 0, 1);
  CHECK(std::abs(glm::dot(d->app().scene.camera.orientation, home.orientation)) < 0.999);
  d->tap("Home");
  CHECK(d->app().scene.camera == home);
  d->hold("Ctrl+Up");
  d->frames(20);
  d->letGo("Ctrl+Up");
  CHECK(std::abs(glm::dot(d->app().scene.camera.orientation, home.orientation)) < 0.999);
  d->tap("Home");
  d->hold("Shift+Left");
  d->frames(20);
  d->letGo("Shift+Left");
  CHECK(glm::distance(d->app().scene.camera.target.A, home.target.A) > 1.0);
  CHECK(std::abs(glm::dot(d->app().scene.camera.orientation, home.orientation)) == doctest::Approx(1.0));
}

TEST_CASE("turning the view by 200 pixels leaves the probe free, outside the molecule") {
  auto d = startWith();
  d->drag("view", 200, 40, 1);
  d->frames(10);
  CHECK(d->text("status/contact") == "free");
}

TEST_CASE("a pointer that hovers across the whole protein touches nothing on its way") {
  auto d = startWith();
  double greatest_N = 0;
  for (int k = 0; k <= 40; ++k) {
    d->point("view", 0.2 + 0.015 * k, 0.3 + 0.01 * k);
    greatest_N = std::max(greatest_N, d->app().scene.log().greatest_N());
  }
  d->frames(10);
  CHECK(greatest_N < 0.05);
  CHECK(d->text("status/contact") == "free");
}

TEST_CASE("switching the tracker while touching keeps the contact") {
  auto d = startWith();
  d->point("view");
  d->press();
  d->frames(90);
  REQUIRE(d->app().scene.log().touching());
  const Vec3 scp = d->app().scene.log().latest().contact.scp.A;
  for (const Method& m : methods()) {
    useMethod(d->app().scene, m.name);
    d->frames(2);
    CAPTURE(m.name);
    CHECK(d->app().scene.log().touching());
    if (!m.summed)  // it has no surface point of its own: its push sums up all spheres
      CHECK(glm::distance(d->app().scene.log().latest().contact.scp.A, scp) < 0.6);
  }
}

TEST_CASE("a larger probe while touching carries the hand's proxy outward") {
  auto d = startWith("argon");
  d->point("view");
  d->press();
  d->frames(60);
  REQUIRE(d->app().scene.log().touching());
  const double before_A = glm::length(d->app().scene.log().latest().contact.scp.A);
  d->app().scene.servo_settings.probe_A = 2.4;
  d->frames(30);
  CHECK(glm::length(d->app().scene.log().latest().contact.scp.A) - before_A == doctest::Approx(1.0).epsilon(0.01));
}

TEST_CASE("a hand that is placed inside gets one message to come out") {
  auto d = startWith("argon");
  d->app().scene.servo().mouse().place(d->app().scene.stage().workspace.toDevice({Vec3(0.0)}));
  ++d->app().scene.servo_settings.discontinuities;
  d->app().scene.servo().loop().setSettings(d->app().scene.servo_settings);
  // One tick before the hand is led out again by the pointer's place.
  d->app().scene.advance(0.001, 0.0, false);
  CHECK(d->app().scene.log().latest().contact.fault == Fault::StartedInside);
  CHECK(d->app().scene.log().force_N() == 0.0);
}

namespace {

// Frames go on until something is felt, at most 2 minutes. Those of a test take less than a tick's time; the thread has
// its own, however busy the machine is.
bool untilTouching(ScriptedUser& d, ServoClock clock) {
  using namespace std::chrono_literals;
  const auto since = std::chrono::steady_clock::now();
  while (!d.app().scene.log().touching() && std::chrono::steady_clock::now() - since < 2min) {
    d.frames(1);
    if (clock == ServoClock::RealThread) std::this_thread::sleep_for(2ms);
  }
  return d.app().scene.log().touching();
}

}  // namespace

TEST_CASE("a new molecule begins without what was felt of the old one, on the frames' clock and with the real thread") {
  for (const ServoClock clock : {ServoClock::Frames, ServoClock::RealThread}) {
    ScriptedUser::Options options;
    options.application.clock = clock;
    auto d = startWith("1ubq", options);
    d->frames(3);
    d->point("view");
    d->press();
    REQUIRE(untilTouching(*d, clock));
    d->release();
    const std::uint32_t old = d->app().scene.servo().scene();
    d->app().open("argon");
    d->app().finishLoading();
    CHECK_FALSE(d->app().scene.log().touching());
    CHECK(d->app().scene.servo().scene() == old + 1);
    for (int seen = 0; seen < 50;) {
      for (const ServoSample& s : d->app().scene.servo().advance(1e-3)) {
        CHECK(s.scene == old + 1);
        // Of argon's one atom; the protein's contact was with another.
        CHECK(s.contact.atoms[0] <= 0);
        ++seen;
      }
    }
  }
}

TEST_CASE("with the real haptic thread a press touches") {
  ScriptedUser::Options options;
  options.application.clock = ServoClock::RealThread;
  auto d = startWith("1ubq", options);
  d->point("view");
  d->press();
  CHECK(untilTouching(*d, ServoClock::RealThread));
  d->release();
}

}  // namespace moltact
