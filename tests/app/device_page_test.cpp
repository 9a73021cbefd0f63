// A device in the window on the frames' clock: chosen on its page, felt, unplugged, stopped.
#include <cmath>
#include <cstdlib>
#include <limits>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/device/simulated_device.h"
#include "engine/servo/safety_stage.h"
#include "engine/workspace/scale.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

SimulatedDevice& stylus(ScriptedUser& d) {
  return dynamic_cast<SimulatedDevice&>(*d.app().scene.servo().loop().device());
}

// A device whose hand rests and that asks for the view.
class Cap final : public Device {
 public:
  explicit Cap(ViewMotion& wish) : wish_(wish) { info_.name = "Cap"; }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override { return {.position = {{0, 0, 79}}}; }
  void write(ForceN) noexcept override {}
  ViewMotion viewMotion() noexcept override { return wish_; }

 private:
  DeviceInfo info_{shownForceFigures()};
  ViewMotion& wish_;
};

// A stylus that reports an arbitrary workspace and position, as a recording may.
class Odd final : public Device {
 public:
  Odd(Vec3 room_mm, Vec3 hand_mm) : hand_mm_(hand_mm) {
    info_.name = "Odd";
    info_.workspace_mm = room_mm;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override { return {.position = {hand_mm_}}; }
  void write(ForceN) noexcept override {}

 private:
  DeviceInfo info_{shownForceFigures()};
  Vec3 hand_mm_;
};

// The part of the rectangle at (x, y), 0 to 1 from its upper left corner, shows the hand's dot.
bool dotAt(ScriptedUser& d, const char* name, float x, float y) {
  const WidgetRecord* room = widgets().find(name);
  REQUIRE(room);
  REQUIRE(room->visible());
  const glm::vec2 at = glm::mix(room->low, room->high, glm::vec2(x, y));
  const Picture picture = d.picture();
  const std::uint8_t* c = picture.at(int(at.x), int(at.y));
  const ImU32 dot = look().palette.accent;
  const auto off = [&](int k) { return std::abs(int(c[k]) - int(dot >> (8 * k) & 0xFFu)); };
  return off(0) + off(1) + off(2) < 24;
}

// The simulated stylus in use and pressing.
std::unique_ptr<ScriptedUser> pressing() {
  auto d = startWith();
  d->tap("Ctrl+D");
  d->frames(3);
  REQUIRE(d->click("device/simulated"));
  d->tap("Escape");
  for (int k = 0; k < 600 && d->app().scene.log().force_N() < 0.5; ++k) d->frames(1);
  REQUIRE(d->app().scene.log().force_N() >= 0.5);
  return d;
}

}  // namespace

TEST_CASE(
    "the device page lists what can be used and why the rest cannot, and a chosen stylus leads: live place, scale and "
    "limits") {
  auto d = startWith();
  d->tap("Ctrl+D");
  d->frames(3);
  CHECK(d->shows("device/mouse"));
  CHECK(d->text("device/name") == "Mouse");
  CHECK(contains(d->text("device/limits"), "gives no force"));
  CHECK(d->click("device/simulated"));
  d->frames(3);
  CHECK(d->text("status/device") == "Simulated stylus");
  CHECK(d->text("device/name") == "Simulated stylus");
  CHECK(contains(d->text("device/live"), "\u00a0mm; force "));
  CHECK(contains(d->text("device/scale"),
                 "1\u00a0mm here is 0.25\u00a0Å there, 1\u00a0N here would be 130\u00a0pN there."));
  CHECK(contains(d->text("device/scale reason"),
                 "Two carbon atoms pressed that far into each other would push back with "));
  // A spring stiffer than the stylus can render counts with the rendered stiffness.
  const double bound = SafetyStage(d->app().scene.servo().device()).stiffnessBound_N_per_mm();
  d->app().scene.servo_settings.stiffness_N_per_mm = 2 * bound;
  d->frames(3);
  CHECK(d->text("device/scale") == scaleSentence(d->app().scene.servo_settings.workspace, bound));
  CHECK(contains(d->text("device/limits"), "At most 3.3\u00a0N for a moment and 0.88\u00a0N for good"));
  CHECK(contains(d->text("device/torque"), "a torque of at most 170\u00a0N\u00a0mm."));
  CHECK(d->click("device/mouse"));
  d->frames(3);
  CHECK(d->text("status/device") == "Mouse");
}

TEST_CASE(
    "a hand 1e37 mm and farther off is drawn at its room's edge, one that is no number in the middle, and a room of no "
    "length, of less than none, of 1e37 mm or NaN is not drawn") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  auto d = startWith();
  d->tap("Ctrl+D");
  const auto show = [&](Vec3 room_mm, Vec3 hand_mm) {
    d->app().scene.servo().setDevice(std::make_unique<Odd>(room_mm, hand_mm));
    d->frames(3);
    CHECK(d->text("device/name") == "Odd");
    CHECK(d->shows("device/live"));
  };
  const Vec3 room(160, 120, 70);
  show(room, {40, 30, 0});
  CHECK(dotAt(*d, "device/front", 0.75f, 0.25f));
  CHECK_FALSE(dotAt(*d, "device/front", 0.5f, 0.5f));
  for (const double far_mm : {1e37, 1e300, kInfinity}) {
    CAPTURE(far_mm);
    show(room, {far_mm, -far_mm, 0});
    CHECK(contains(d->text("device/live"), "Hand at –, –, 0.0\u00a0mm;"));
    CHECK(dotAt(*d, "device/front", 1.0f, 1.0f));
    show(room, {-far_mm, far_mm, -far_mm});
    CHECK(dotAt(*d, "device/front", 0.0f, 0.0f));
  }
  const double nan = std::nan("");
  show(room, {nan, nan, nan});
  CHECK(dotAt(*d, "device/front", 0.5f, 0.5f));
  CHECK(dotAt(*d, "device/above", 0.5f, 0.5f));
  for (const double side_mm : {0.0, -120.0, 1e-300, 1e37, 1.7e308, kInfinity, nan})
    for (int k = 0; k < 3; ++k) {
      Vec3 odd = room;
      odd[k] = side_mm;
      show(odd, {10, 10, 10});
      CHECK_FALSE(d->shows("device/front"));
    }
}

TEST_CASE("unplugging in contact: the mouse leads, a message says so; plugged in again the stylus leads") {
  auto d = pressing();
  stylus(*d).plug(false);
  d->frames(1);
  CHECK(d->app().scene.servo().loop().fallenBack());
  d->frames(20);
  CHECK(d->text("status/device") == "Mouse");
  CHECK(contains(d->text("message/0") + d->text("message/1"), "Until then the mouse leads"));
  CHECK(d->app().scene.log().force_N() == 0.0);
  stylus(*d).plug(true);
  d->frames(20);
  CHECK(d->text("status/device") == "Simulated stylus");
  CHECK_FALSE(d->app().scene.servo().loop().fallenBack());
}

TEST_CASE("F9 stops all force at once and says so over the view; F9 again allows it, softly") {
  auto d = pressing();
  d->tap("F9");
  d->frames(2);
  CHECK(contains(d->text("limits"), "All force is stopped"));
  CHECK(d->app().scene.servo().newest().force.N == Vec3(0));
  d->tap("F9");
  d->frames(2);
  CHECK_FALSE(d->app().scene.servo_settings.panic);
  CHECK(glm::length(d->app().scene.servo().newest().force.N) < 0.5);
}

TEST_CASE("the gentle force of the device page pulls with 0.4 N for 4 s, and then the molecule is felt again") {
  auto d = startWith();
  d->tap("Ctrl+D");
  d->frames(3);
  d->click("device/simulated");
  d->frames(2);
  DeviceLink& link = d->app().extensions().device;
  link.tryForce();
  double greatest = 0;
  for (int k = 0; k < 230; ++k) {
    d->frames(1);
    greatest = std::max(greatest, glm::length(d->app().scene.servo().newest().force.N));
  }
  CHECK(greatest > 0.35);
  CHECK(greatest < 0.6);
  d->frames(30);
  CHECK(link.tryingLeft_s() == 0.0);
  CHECK(d->app().scene.servo().newest().scene == d->app().scene.servo().scene());
}

TEST_CASE(
    "a cap that is turned fully for a second turns the view by 1.5 rad to the right; pulled up it moves half the "
    "view's height, toward the person it comes "
    "2.2 times as close") {
  auto d = startWith();
  ViewMotion wish;
  d->app().scene.servo().setDevice(std::make_unique<Cap>(wish));
  d->frames(2);
  const Camera before = d->app().scene.camera;
  wish.rotation = {0, 1, 0};
  d->frames(60);
  wish = {};
  d->frames(2);
  const Camera& now = d->app().scene.camera;
  // What was on the right comes to the front: the camera's right turns away from it.
  CHECK(glm::dot(now.right(), before.right()) == doctest::Approx(std::cos(1.5)).epsilon(1e-3));
  CHECK(glm::dot(now.right(), before.back()) == doctest::Approx(std::sin(1.5)).epsilon(1e-3));
  CHECK(now.target.A == before.target.A);
  const Vec3 up = now.up(), target = now.target.A;
  wish.move = {0, 1, 0};
  d->frames(60);
  const double height_A = 2.0 * now.tanHalfY() * now.distance_A;
  CHECK(glm::dot(now.target.A - target, up) == doctest::Approx(-0.5 * height_A).epsilon(0.01));
  wish.move = {0, 0, 1};
  const double distance_A = now.distance_A;
  d->frames(60);
  CHECK(now.distance_A == doctest::Approx(distance_A / 2.2).epsilon(1e-3));
}

TEST_CASE("with a stylus the screen's right is the device's right, also after the view was turned") {
  auto d = pressing();
  d->drag("view", 150, 40, 1);
  d->frames(3);
  const glm::dmat3& turn = d->app().scene.servo_settings.workspace.rotation;
  CHECK(glm::distance(turn[0], d->app().scene.camera.right()) < 1e-6);
  CHECK(glm::distance(turn[2], d->app().scene.camera.back()) < 1e-6);
}

}  // namespace moltact
