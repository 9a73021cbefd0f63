// The clutch, and a change of scale during contact, in closed form.
#include "engine/servo/clutch.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/device/mouse_device.h"
#include "engine/haptics/methods.h"
#include "engine/servo/servo_step.h"
#include "engine/workspace/scale.h"

using namespace moltact;

TEST_CASE(
    "in contact a scale 2.5 times as fine keeps the contact and gives 2.5 times the force, from nothing in half a "
    "second") {
  auto tracker =
      methods().front().make(std::make_shared<const SphereGrid>(std::vector<Sphere>{{{0, 0, 0}, 1.6}}), kWaterProbe_A);
  ServoStep step;
  ServoSettings settings;  // 0.25 A a mm, the surface at 12 mm
  DevicePose pose;
  for (double z = 20; z >= 10.6; z -= 0.1) pose.position.mm = {0, 0, z}, step.tick(settings, tracker.get(), pose);
  ServoSample s;
  for (int k = 0; k < 600; ++k) s = step.tick(settings, tracker.get(), pose);
  const double coarse_N = s.force.N.z;
  CHECK(coarse_N == doctest::Approx(0.5 * (12.0 - s.hand.mm.z)));
  settings.workspace = rescaled(settings.workspace, 0.1, s.hand, s.hip);
  Vec3 last = s.force.N;
  for (int k = 0; k < 500; ++k) {
    s = step.tick(settings, tracker.get(), pose);
    CHECK(s.contact.touching());
    CHECK(glm::distance(s.force.N, last) <= 1.0 + 1e-9);
    if (k == 4) CHECK(s.force.N.z < 0.05);
    last = s.force.N;
  }
  CHECK(s.force.N.z == doctest::Approx(2.5 * coarse_N).epsilon(0.01));
}

namespace {
// A hand that is never quite still: 1 mm to and fro, ten times a second.
Vec3 alive(const Vec3& place_mm, int tick) { return place_mm + Vec3(0, std::sin(tick * 0.0628), 0); }
}  // namespace

TEST_CASE(
    "clutch: with the button held the hand goes back 30 mm and the probe stays; let go, it continues from there") {
  Clutch clutch;
  const ClutchSettings settings{.buttons = 2};
  const Vec3 room(160, 120, 70);
  const auto at = [&](double x, std::uint32_t buttons) {
    DevicePose pose;
    pose.position.mm.x = x;
    pose.buttons = buttons;
    return clutch.place(pose, settings, room, Vec3(0.0), 0.001).mm.x;
  };
  CHECK(at(40, 0) == 40);
  for (int k = 0; k <= 30; ++k) CHECK(at(40 - k, 2) == 40);
  CHECK(clutch.held());
  CHECK(at(10, 0) == 40);
  CHECK(at(15, 0) == 45);
  CHECK_FALSE(clutch.held());
  CHECK(at(15, 1) == 45);  // another button
}

TEST_CASE(
    "clutch: while it is held no motion of the wrist turns the hand, and let go the wrist turns it on from there: four "
    "grips of 60 degrees turn a body by 240") {
  Clutch clutch;
  const ClutchSettings settings{.buttons = 2};
  const Vec3 axis = glm::normalize(Vec3(1, 2, -0.5));
  const auto at = [&](const Quat& stylus, std::uint32_t buttons) {
    DevicePose pose;
    pose.orientation = stylus;
    pose.buttons = buttons;
    clutch.place(pose, settings, Vec3(160), Vec3(0.0), 0.001);
    return clutch.orient(stylus);
  };
  const double grip = kTwoPi / 6.0;
  Quat last = at(kNoRotation, 0);
  CHECK(last == kNoRotation);
  for (int k = 0; k < 4; ++k) {
    const Quat before = last;
    for (int i = 1; i <= 20; ++i) {  // the wrist turns the hand about the same axis by as much
      last = at(glm::angleAxis(grip * i / 20, axis), 0);
      CHECK(glm::length(rotationBetween(before, last) - axis * (grip * i / 20)) < 1e-12);
    }
    for (int i = 0; i <= 20; ++i) {  // back, and astray about another axis meanwhile
      const Quat astray = glm::angleAxis(0.7 * std::sin(kTwoPi * i / 20.0), Vec3(0, 0, 1));
      const Quat held = at(astray * glm::angleAxis(grip * (20 - i) / 20, axis), 2);
      CHECK(glm::length(rotationBetween(last, held)) < 1e-12);
    }
    const Quat after = at(kNoRotation, 0);  // no jump
    CHECK(glm::length(rotationBetween(last, after)) < 1e-12);
    last = after;
  }
  const Quat expected = glm::angleAxis(4 * grip, axis);
  CHECK(std::abs(glm::dot(last, expected)) == doctest::Approx(1.0).epsilon(1e-12));
  // A hand placed elsewhere keeps the grips; a device that was lost does not.
  clutch.restart();
  CHECK(glm::length(rotationBetween(last, at(kNoRotation, 0))) < 1e-12);
  clutch.forget();
  CHECK(at(kNoRotation, 0) == kNoRotation);
}

TEST_CASE(
    "clutch: without a grip every orientation passes to the last bit, and one that is no rotation changes nothing") {
  Clutch clutch;
  const ClutchSettings settings{.buttons = 1};
  const auto at = [&](const Quat& stylus, std::uint32_t buttons) {
    DevicePose pose;
    pose.orientation = stylus;
    pose.buttons = buttons;
    clutch.place(pose, settings, Vec3(160), Vec3(0.0), 0.001);
    return clutch.orient(stylus);
  };
  const Quat odd = glm::normalize(Quat(0.3, -0.4, 0.1, 0.7));
  CHECK(at(odd, 0) == odd);
  const Quat none(0, 0, 0, 0);
  CHECK(at(none, 1) == none);
  at(odd, 1);
  CHECK(glm::length(rotationBetween(odd, at(kNoRotation, 1))) < 1e-12);
  CHECK(at(none, 1) == none);
  CHECK(glm::length(rotationBetween(odd, at(kNoRotation, 0))) < 1e-12);
}

TEST_CASE(
    "edge: 5 mm from the edge of a room of 160 mm the probe continues by 10 mm a second, 20 mm from it not at all") {
  Clutch clutch;
  const ClutchSettings settings{.at_edge = true};
  DevicePose pose;
  double x = 0;
  for (int k = 0; k < 1000; ++k)
    pose.position.mm = alive({-75, 0, 0}, k), x = clutch.place(pose, settings, {160, 120, 70}, Vec3(0.0), 0.001).mm.x;
  CHECK(x == doctest::Approx(-85));
  for (int k = 0; k < 1000; ++k)
    pose.position.mm = alive({60, 0, 0}, k), x = clutch.place(pose, settings, {160, 120, 70}, Vec3(0.0), 0.001).mm.x;
  CHECK(x == doctest::Approx(50));
}

TEST_CASE(
    "edge: a stylus that lies in its stand for a minute, 53 mm beyond the edge, takes the probe 30 mm on and no "
    "farther; one in fault not at all") {
  const ClutchSettings settings{.at_edge = true};
  for (const bool fault : {false, true}) {
    Clutch clutch;
    DevicePose pose;
    pose.position.mm = {0, 0, -88};
    pose.fault = fault;
    double z = 0;
    for (int k = 0; k < 60'000; ++k) {
      pose.position.mm.x = k % 2 ? 0.055 : 0.0;  // a sensor between two steps
      z = clutch.place(pose, settings, {160, 120, 70}, Vec3(0.0), 0.001).mm.z;
    }
    CHECK(z == doctest::Approx(fault ? -88 : -118).epsilon(0.001));
  }
}

TEST_CASE("edge: against a surface that pushes up and to the left the probe continues along it, never deeper") {
  Clutch clutch;
  const ClutchSettings settings{.at_edge = true};
  const Vec3 push = glm::normalize(Vec3(-1, 0, 1));
  DevicePose pose;
  Vec3 first(0.0), last(0.0);
  for (int k = 0; k <= 1000; ++k) {
    pose.position.mm = alive({90, 0, 0}, k);
    last = clutch.place(pose, settings, {160, 120, 70}, push, 0.001).mm - pose.position.mm;
    if (k == 0) first = last;
  }
  CHECK(std::abs(glm::dot(last, push)) < 1e-9);
  CHECK((last - first).x == doctest::Approx(10));  // half of 20 mm, for the surface leans by 45 degrees
  CHECK((last - first).z == doctest::Approx(10));
}

TEST_CASE(
    "a mouse that stands in for a device has no edge: 100 mm from the middle for 2 s its probe stays where it is") {
  MouseDevice mouse;
  ServoStep step;
  step.setDevice(mouse.info());
  ServoSettings settings;
  settings.clutch = {.buttons = 2, .at_edge = true};
  DevicePose pose;
  pose.position.mm = {0, 0, 100};
  ServoSample s;
  for (int k = 0; k < 2000; ++k) s = step.tick(settings, nullptr, pose);
  CHECK(s.hand.mm == Vec3(0, 0, 100));
}

TEST_CASE("in the loop the clutch moves the probe's room: no force while it is held, a soft start after it") {
  auto tracker =
      methods().front().make(std::make_shared<const SphereGrid>(std::vector<Sphere>{{{0, 0, 0}, 1.6}}), kWaterProbe_A);
  ServoStep step;
  ServoSettings settings;  // the surface at 12 mm
  settings.clutch.buttons = 1;
  DevicePose pose;
  pose.position.mm = {0, 0, 30};
  step.tick(settings, tracker.get(), pose);
  pose.buttons = 1;
  for (int k = 0; k < 40; ++k) pose.position.mm.z += 0.5, step.tick(settings, tracker.get(), pose);
  pose.buttons = 0;
  ServoSample s;
  for (int k = 0; k < 39; ++k) pose.position.mm.z -= 0.5, s = step.tick(settings, tracker.get(), pose);
  CHECK(s.hand.mm.z == doctest::Approx(11));  // the hand itself is at 30.5
  CHECK(s.contact.touching());
  for (int k = 0; k < 600; ++k) s = step.tick(settings, tracker.get(), pose);
  CHECK(s.force.N.z == doctest::Approx(0.5));
  pose.buttons = 1;
  for (int k = 0; k < 10; ++k) pose.position.mm.z += 0.5, s = step.tick(settings, tracker.get(), pose);
  CHECK(s.force.N == Vec3(0));
}
