// The mouse as a device at 1 kHz: an exponential glide in closed form.
#include "engine/device/mouse_device.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace moltact {
namespace {
constexpr double kMouseTick_s = 0.001;
}

TEST_CASE("after one time constant of 25 ms the hand has gone 63.2 % of a way of 1 mm") {
  MouseDevice mouse;
  mouse.place({{0, 0, 0}});
  mouse.read(kMouseTick_s);
  mouse.lead({{1, 0, 0}});
  DevicePose pose;
  for (int k = 0; k < 25; ++k) pose = mouse.read(kMouseTick_s);
  CHECK(pose.position.mm.x == doctest::Approx(1.0 - std::exp(-1.0)).epsilon(1e-9));
}

TEST_CASE("the hand moves no faster than 0.4 mm a tick") {
  MouseDevice mouse;
  mouse.place({{0, 0, 0}});
  Vec3 before = mouse.read(kMouseTick_s).position.mm;
  mouse.lead({{1000, 1000, 0}});
  for (int k = 0; k < 100; ++k) {
    const Vec3 now = mouse.read(kMouseTick_s).position.mm;
    CHECK(glm::distance(now, before) == doctest::Approx(0.4).epsilon(1e-9));
    before = now;
  }
}

TEST_CASE("a placed hand is there at the next tick") {
  MouseDevice mouse;
  mouse.lead({{5, 5, 5}});
  mouse.place({{70, -20, 3}});
  const DevicePose pose = mouse.read(kMouseTick_s);
  CHECK(pose.position.mm == Vec3(70, -20, 3));
  CHECK(pose.discontinuities == 1);
  CHECK(mouse.read(kMouseTick_s).discontinuities == 1);
}

TEST_CASE("a hand that is placed and led on before the next tick is first where it was placed") {
  MouseDevice mouse;
  mouse.place({{70, -20, 3}});
  mouse.lead({{70, -20, 0}});
  CHECK(mouse.read(kMouseTick_s).position.mm == Vec3(70, -20, 3));
  const double way_mm = 3.0 - mouse.read(kMouseTick_s).position.mm.z;
  CHECK(way_mm == doctest::Approx(3.0 * (1.0 - std::exp(-0.001 / 0.025))).epsilon(1e-9));
}

TEST_CASE("a lead that is not finite is ignored") {
  MouseDevice mouse;
  mouse.place({{1, 2, 3}});
  mouse.read(kMouseTick_s);
  mouse.lead({{std::numeric_limits<double>::quiet_NaN(), 0, 0}});
  mouse.lead({{0, std::numeric_limits<double>::infinity(), 0}});
  for (int k = 0; k < 10; ++k) CHECK(mouse.read(kMouseTick_s).position.mm == Vec3(1, 2, 3));
}

TEST_CASE(
    "the hand turns as it glides, 63.2 % of 0.1 rad in 25 ms and no faster than 6 mrad a tick; what is no rotation is "
    "ignored") {
  MouseDevice mouse;
  mouse.place({{0, 0, 0}});
  mouse.read(kMouseTick_s);
  mouse.turn(glm::angleAxis(0.1, Vec3(0, 1, 0)));
  DevicePose pose;
  for (int k = 0; k < 25; ++k) pose = mouse.read(kMouseTick_s);
  CHECK(rotationBetween(kNoRotation, pose.orientation).y ==
        doctest::Approx(0.1 * (1.0 - std::exp(-1.0))).epsilon(1e-6));
  const Quat far = glm::angleAxis(3.0, Vec3(1, 0, 0));
  mouse.turn(far);
  mouse.turn(Quat(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0));
  mouse.turn(Quat(3, 0, 0, 0));
  for (int k = 0; k < 400; ++k) {
    const Quat before = pose.orientation;
    pose = mouse.read(kMouseTick_s);
    CHECK(glm::length(rotationBetween(before, pose.orientation)) < 0.006 + 1e-9);
  }
  mouse.place({{7, 0, 0}});
  for (int k = 0; k < 600; ++k) pose = mouse.read(kMouseTick_s);
  CHECK(glm::length(rotationBetween(pose.orientation, far)) < 1e-6);
}

}  // namespace moltact
