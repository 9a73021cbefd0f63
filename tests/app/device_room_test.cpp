// A molecule in the workspace of a haptic device: an Omni's, 160 x 120 x 70 mm. Oracle: the spheres' own distances.
#include <cmath>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "engine/haptics/sweep.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// A stylus with an Omni's properties. The test sets the target of its hand, which moves there at no more than 100 mm/s.
class Held final : public Device {
 public:
  explicit Held(Vec3 at_mm) : place_mm(at_mm), goal_mm(at_mm) {
    info_.name = "Held stylus";
    info_.gives_force = true;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double dt_s) noexcept override {
    const Vec3 way = goal_mm - place_mm;
    const double length = glm::length(way), most = 100.0 * dt_s;
    place_mm = length > most ? place_mm + way * (most / length) : goal_mm;
    return {.position = {place_mm}, .connected = connected};
  }
  void write(ForceN) noexcept override {}
  DeviceStatus status() override {
    return {.connected = connected, .ready = connected, .text = connected ? "" : "It is unplugged."};
  }
  Vec3 place_mm, goal_mm;
  bool connected = true;

 private:
  DeviceInfo info_{phantomOmniFigures()};
};

Held& hold(ScriptedUser& d, Vec3 at_mm = Vec3(0)) {
  auto made = std::make_unique<Held>(at_mm);
  Held& held = *made;
  d.app().scene.servo().setDevice(std::move(made));
  d.app().scene.servo_settings.clutch = {.buttons = 2, .at_edge = true};  // as the device page sets it
  d.frames(6);
  return held;
}

const ServoSample& now(ScriptedUser& d) { return d.app().scene.log().latest(); }

// The gap between the probe and the nearest sphere (unit: angstrom), sphere by sphere.
double gap_A(ScriptedUser& d) {
  double least = 1e9;
  for (const Sphere& b : d.app().scene.stage().molecule->spheres)
    least = std::min(least, glm::distance(b.centre_A, now(d).hip.A) - b.radius_A - now(d).probe_A);
  return least;
}

// Moves the hand there and waits.
void go(ScriptedUser& d, Held& stylus, Vec3 to_mm) {
  stylus.goal_mm = to_mm;
  for (int k = 0; k < 200 && stylus.place_mm != to_mm; ++k) d.frames(1);
  d.frames(3);
}

}  // namespace

TEST_CASE(
    "a stylus in the middle of an Omni's room is free before the molecule, as far as its surface lies behind; 35 mm "
    "farther it touches, with the scale of the "
    "mouse, and drawn back to the person's edge it is free again: for molecules of 2 to 4600 atoms") {
  for (const char* molecule : {"argon-pair", "benzene", "b-dna", "1ubq", "1hel", "2hhb"}) {
    CAPTURE(std::string(molecule));
    auto d = startWith(molecule);
    const double by_mouse_A_per_mm = d->app().scene.servo_settings.workspace.A_per_mm;
    Held& stylus = hold(*d);
    CHECK(d->app().scene.servo_settings.workspace.A_per_mm == by_mouse_A_per_mm);
    CHECK(now(*d).contact.fault == Fault::None);
    CHECK_FALSE(now(*d).contact.touching());
    CHECK(gap_A(*d) > 0.0);
    // The surface straight ahead is a fifth of the room's depth away.
    const Workspace& w = d->app().scene.servo_settings.workspace;
    const Vec3 ahead = -d->app().scene.camera.back();
    const Hit hit =
        sweep(*d->app().scene.stage().spheres, now(*d).probe_A, now(*d).hip.A, now(*d).hip.A + ahead * 100.0);
    if (hit.sphere >= 0) CHECK(hit.t * 100.0 / w.A_per_mm == doctest::Approx(0.2 * 70.0).epsilon(0.01));
    go(*d, stylus, {0, 0, -35});
    if (hit.sphere >= 0) {
      CHECK(now(*d).contact.touching());
      CHECK(d->app().scene.log().force_N() > 0.3);
    }
    go(*d, stylus, {0, 0, 30});
    CHECK_FALSE(now(*d).contact.touching());
    CHECK(now(*d).contact.fault == Fault::None);
  }
}

TEST_CASE(
    "wherever the hand is in its room when the device is chosen, and whichever way the view is turned then, it does "
    "not begin inside") {
  auto d = startWith("1ubq");
  int deep = 0;
  for (const Vec3 at : {Vec3(0, 0, -34), Vec3(60, -40, -30), Vec3(-50, 30, 0), Vec3(20, 20, 34), Vec3(-75, 0, -34)}) {
    hold(*d, at);
    for (int turn = 0; turn < 6; ++turn) {
      CAPTURE(at.z);
      CAPTURE(turn);
      d->drag("view", 90.0 - 37.0 * turn, 50.0 + 13 * turn, 1);
      d->frames(40);
      CHECK(now(*d).contact.fault == Fault::None);
      // Free, or led on by the room's edge and in contact.
      CHECK((gap_A(*d) > 0.0 || now(*d).contact.touching()));
      deep += gap_A(*d) < 5.0 * d->app().scene.servo_settings.workspace.A_per_mm + 1e-6;
    }
  }
  CHECK(deep > 0);  // the molecule was moved back for some of them
}

TEST_CASE(
    "turned in contact the force is gone and grows from nothing, and what is in the middle of the view is what the "
    "hand meets") {
  auto d = startWith("1ubq");
  Held& stylus = hold(*d);
  go(*d, stylus, {0, 0, -24});
  d->frames(40);
  REQUIRE(d->app().scene.log().force_N() > 0.5);
  d->drag("view", 150, 40, 1);
  d->frames(1);
  CHECK(d->app().scene.log().force_N() < 0.3);
  go(*d, stylus, {0, 0, 10});
  go(*d, stylus, {0, 0, -30});
  REQUIRE(now(*d).contact.touching());
  const auto size = d->app().layout().view.size();
  const Vec3 px = d->app().scene.camera.project(now(*d).hip, int(size.x), int(size.y));
  CHECK(px.x == doctest::Approx(0.5 * double(size.x)).epsilon(0.02));
  CHECK(px.y == doctest::Approx(0.5 * double(size.y)).epsilon(0.02));
}

TEST_CASE("a view that is moved aside brings another part before the hand; brought closer it changes nothing") {
  auto d = startWith("1ubq");
  hold(*d);
  const Vec3 before = d->app().scene.servo_settings.workspace.centre_A;
  const std::uint32_t discontinuities = d->app().scene.servo_settings.discontinuities;
  d->app().scene.camera.zoom(1.5);
  d->frames(3);
  CHECK(d->app().scene.servo_settings.discontinuities == discontinuities);
  d->app().scene.camera.pan(120, 0, 700);
  d->frames(3);
  const Camera& camera = d->app().scene.camera;
  const Vec3 off = camera.target.A - d->app().scene.servo_settings.workspace.centre_A;
  CHECK(glm::length(off - camera.back() * glm::dot(off, camera.back())) < 1e-9);
  CHECK(glm::distance(before, d->app().scene.servo_settings.workspace.centre_A) > 1.0);
}

TEST_CASE(
    "a front that lies farther to the side than the room is reached by the edge: held there the probe continues until "
    "it "
    "meets nothing more") {
  auto d = startWith("1ubq");
  Held& stylus = hold(*d);
  go(*d, stylus, {79, 0, 10});
  const double x_A = glm::dot(now(*d).hip.A, d->app().scene.camera.right());
  // A hand is never quite still.
  for (int k = 0; k < 60; ++k) go(*d, stylus, {k % 2 ? 79.0 : 78.0, 0, 10});
  CHECK(glm::dot(now(*d).hip.A, d->app().scene.camera.right()) > x_A + 5.0);
}

TEST_CASE(
    "unplugged the mouse has its own mapping, as if no device had been there, and its probe is where it was; plugged "
    "in again the stylus is free before the "
    "molecule") {
  auto d = startWith("1ubq");
  const Workspace mouse = d->app().scene.servo_settings.workspace;
  d->point("view", 0.55, 0.45);
  d->frames(30);
  Held& stylus = hold(*d);
  go(*d, stylus, {0, 0, -30});
  stylus.connected = false;
  d->frames(10);
  const Workspace& now_w = d->app().scene.servo_settings.workspace;
  CHECK(now_w.centre_A == mouse.centre_A);
  CHECK(now_w.A_per_mm == mouse.A_per_mm);
  CHECK(now_w.rotation == mouse.rotation);
  CHECK(glm::distance(now(*d).hip.A, d->app().scene.controls.lead().A) < 0.05);
  CHECK(now(*d).contact.fault == Fault::None);
  stylus.place_mm = stylus.goal_mm = Vec3(0);
  stylus.connected = true;
  d->frames(10);
  CHECK(d->app().scene.servo().deviceLeads());
  CHECK(now(*d).contact.fault == Fault::None);
  CHECK(gap_A(*d) > 0.0);
}

TEST_CASE("a place that a task turns to the front lies before the hand, which begins outside") {
  auto d = startWith("1ubq");
  Held& stylus = hold(*d);
  const PointA place = PointA{d->app().scene.stage().molecule->spheres[300].centre_A};
  d->app().beginSceneAgain(place);
  d->frames(60);
  CHECK(now(*d).contact.fault == Fault::None);
  const Vec3 off = place.A - now(*d).hip.A, back = d->app().scene.camera.back();
  CHECK(glm::length(off - back * glm::dot(off, back)) < 0.02);
  go(*d, stylus, {0, 0, -30});
  CHECK(now(*d).contact.touching());
}

}  // namespace moltact
