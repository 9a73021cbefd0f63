// What the reports of HID devices mean, garbage and short ones included.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/bench/scenes.h"
#include "engine/device/hid/open_device.h"
#include "engine/device/hid/play_station.h"
#include "engine/device/hid/space_mouse.h"
#include "engine/device/hid/wooden_haptics.h"
#include "tests/device/open_firmware.h"
#include "tests/device/wire_port.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE("SpaceMouse: two reports of 7 bytes and one of 13 mean the same axes; x right, up against z, toward the person y") {
  // Half a push to the right (175), none away, a full one up (-350); turned by a quarter round y.
  const Report push{1, 175, 0, 0, 0, 0xA2, 0xFE}, turn{2, 0, 0, 0, 0, 87, 0}, both{1, 175, 0, 0, 0, 0xA2, 0xFE, 0, 0, 0, 0, 87, 0};
  SpaceMouseProtocol old, newer;
  DevicePose pose;
  CHECK(old.take(push, pose));
  CHECK(old.take(turn, pose));
  CHECK(newer.take(both, pose));
  for (const SpaceMouseProtocol* one : {&old, &newer}) {
    CHECK(one->axes().push.x == doctest::Approx(0.5));
    CHECK(one->axes().push.y == doctest::Approx(1.0));
    CHECK(one->axes().push.z == 0.0);
    CHECK(one->axes().turn.y == doctest::Approx(-87.0 / 350));
  }
  CHECK(old.take(Report{3, 0x05, 0x01}, pose));
  CHECK(pose.buttons == 0x0104u);  // the first switches between hand and view
}

TEST_CASE("SpaceMouse: a full push moves the hand by 60 mm a second, a breath of one not at all, and 80 mm is the end of the way") {
  SpaceMouseProtocol mouse;
  DevicePose pose;
  mouse.take(Report{1, 0x5E, 0x01, 0, 0, 0, 0}, pose);
  for (int k = 0; k < 100; ++k) mouse.pass(0.002, pose);
  CHECK(pose.position.mm.x == doctest::Approx(12.0));
  for (int k = 0; k < 2000; ++k) {
    mouse.take(Report{1, 0x5E, 0x01, 0, 0, 0, 0}, pose);
    mouse.pass(0.002, pose);
  }
  CHECK(pose.position.mm.x == 80.0);
  mouse.take(Report{1, 0xEF, 0xFF, 0, 0, 0, 0}, pose);  // -17 of 350
  mouse.pass(0.1, pose);
  CHECK(pose.position.mm.x == 80.0);
}

TEST_CASE("SpaceMouse: a turn that is stronger than the push turns the view and leaves the hand; the first button gives the push to the view, too") {
  SpaceMouseProtocol mouse;
  DevicePose pose;
  // Pushed right by 100 of 350, turned round the axis that points down by -350: seen from above to the left.
  const Report both{1, 100, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xA2, 0xFE}, push{1, 0x5E, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  mouse.take(both, pose);
  mouse.pass(0.01, pose);
  CHECK(pose.position.mm == Vec3(0));
  CHECK(mouse.viewWish().turn.y == doctest::Approx(1.0));
  CHECK(mouse.viewWish().move == Vec3(0));
  mouse.take(push, pose);
  mouse.pass(0.01, pose);
  CHECK(pose.position.mm.x == doctest::Approx(0.6));
  CHECK(mouse.viewWish().turn == Vec3(0));
  mouse.take(Report{3, 1}, pose);
  mouse.take(Report{3, 0}, pose);
  CHECK(pose.buttons == 0);
  mouse.pass(0.01, pose);
  CHECK(pose.position.mm.x == doctest::Approx(0.6));
  CHECK(mouse.viewWish().move.x == doctest::Approx(1.0));
  mouse.take(Report{3, 1}, pose);
  mouse.pass(0.01, pose);
  CHECK(pose.position.mm.x == doctest::Approx(1.2));
  CHECK(mouse.viewWish().move == Vec3(0));
}

TEST_CASE("DualShock 4: left stick right and up, right trigger in, right stick the view; sticks that rest beside their middle move nothing") {
  PlayStationProtocol pad;
  DevicePose pose;
  Report report(64);
  report[0] = 1, report[1] = 120, report[2] = 133, report[3] = 128, report[4] = 128, report[5] = 8;
  CHECK(pad.take(report, pose));
  for (int k = 0; k < 100; ++k) pad.pass(0.01, pose), pad.take(report, pose);
  CHECK(pose.position.mm == Vec3(0));
  CHECK(pose.buttons == 0);
  report[1] = 255, report[2] = 128, report[5] = 0x20 | 8;  // right, with the cross
  pad.take(report, pose);
  pad.pass(0.1, pose);
  CHECK(pose.position.mm.x == doctest::Approx(6.0));
  CHECK(pose.buttons == 1);
  report[1] = 128, report[2] = 0, report[5] = 0x40 | 8;  // up, with the circle
  pad.take(report, pose);
  pad.pass(0.1, pose);
  CHECK(pose.position.mm.y == doctest::Approx(6.0));
  CHECK(pose.buttons == 2);
  report[2] = 128, report[9] = 255, report[3] = 255;
  pad.take(report, pose);
  pad.pass(0.1, pose);
  CHECK(pose.position.mm.z == doctest::Approx(-6.0));
  CHECK(pad.viewWish().turn.y == doctest::Approx(1.0));
  pad.pass(0.3, pose);  // the report of letting go was lost
  pad.pass(0.1, pose);
  CHECK(pose.position.mm.z > -30.0);
  CHECK(pad.viewWish().turn == Vec3(0));
  CHECK_FALSE(pad.take(Report(63), pose));
}

TEST_CASE("DualSense: triggers, buttons and motors stand elsewhere by USB, by Bluetooth where the DualShock 4 has them") {
  PlayStationProtocol pad(kDualSense);
  DevicePose pose;
  Report usb(64), bluetooth(10);
  for (Report* one : {&usb, &bluetooth}) (*one)[0] = 1, (*one)[1] = (*one)[2] = (*one)[3] = (*one)[4] = 128;
  usb[6] = 255, usb[8] = 0x20 | 8;  // right trigger, cross
  CHECK(pad.take(usb, pose));
  pad.pass(0.1, pose);
  CHECK(pose.position.mm.z == doctest::Approx(-6.0));
  CHECK(pose.buttons == 1);
  std::array<std::uint8_t, 64> out{};
  CHECK(pad.give({Vec3(0, 3.3, 0)}, out) == 48);
  CHECK((out[0] == 2 && out[1] == 3 && out[2] == 0 && out[3] == 255 && out[4] == 255));
  bluetooth[8] = 255, bluetooth[5] = 0x40 | 8;  // left trigger, circle
  CHECK(pad.take(bluetooth, pose));
  pad.pass(0.1, pose);
  CHECK(pose.position.mm.z == doctest::Approx(0.0));
  CHECK(pose.buttons == 2);
  CHECK(pad.give({Vec3(0.1, 0, 0)}, out) == 0);
}

TEST_CASE("DualShock 4: it rumbles by the force over USB, a report where the strength changes; at 3.3 N both motors fully, at none not, over Bluetooth never") {
  PlayStationProtocol pad;
  DevicePose pose;
  std::array<std::uint8_t, 64> out{};
  Report usb(64), bluetooth(10);
  usb[0] = bluetooth[0] = 1;
  pad.take(bluetooth, pose);
  CHECK(pad.give({Vec3(3.3, 0, 0)}, out) == 0);
  pad.take(usb, pose);
  CHECK(pad.give({Vec3(0, 3.3, 0)}, out) == 32);
  CHECK((out[0] == 5 && out[1] == 1 && out[4] == 255 && out[5] == 255));
  CHECK(pad.give({Vec3(0, 0, 3.3)}, out) == 0);
  CHECK(pad.give({Vec3(0.5, 0, 0)}, out) == 32);
  CHECK((out[4] > 0 && out[4] < 80 && out[5] == 0));
  CHECK(pad.give({Vec3(std::nan(""), 0, 0)}, out) == 32);
  CHECK((out[4] == 0 && out[5] == 0));
}

TEST_CASE("SpaceMouse: when the report of letting go is lost the hand stands after a quarter of a second") {
  SpaceMouseProtocol mouse;
  DevicePose pose;
  mouse.take(Report{1, 0x5E, 0x01, 0, 0, 0, 0}, pose);
  for (int k = 0; k < 1000; ++k) mouse.pass(0.002, pose);
  CHECK(pose.position.mm.x < 60 * 0.26);
}

TEST_CASE("10 000 reports of random length and bytes leave every protocol's place finite and within what 16 bits can say; seed 1") {
  scenes::Random random(1);
  SpaceMouseProtocol mouse;
  WoodenHapticsProtocol wood;
  OpenProtocol open;
  PlayStationProtocol pad;
  DevicePose pose;
  std::array<std::uint8_t, 64> out{};
  for (int k = 0; k < 10'000; ++k) {
    Report report(std::size_t(random.uniform(0, 65)));
    for (auto& byte : report) byte = std::uint8_t(random.uniform(0, 256));
    if (k % 2 && !report.empty()) report[0] = std::uint8_t(1 + k / 2 % 3);
    for (HidProtocol* one : {static_cast<HidProtocol*>(&mouse), static_cast<HidProtocol*>(&wood), static_cast<HidProtocol*>(&open),
                              static_cast<HidProtocol*>(&pad)}) {
      one->take(report, pose);
      one->pass(0.001, pose);
      REQUIRE(finite(pose.position.mm));
      REQUIRE(glm::length(pose.position.mm) < 1000);
      one->give({Vec3(random.uniform(-9, 9), std::nan(""), 0)}, out);
    }
  }
}

TEST_CASE("WoodenHaptics: at rest the handle is 220 mm behind and 40 mm under the middle, and work is the same at motor and hand") {
  const Vec3 rest = WoodenHapticsProtocol::place(Vec3(0)).mm;
  CHECK(rest.z == doctest::Approx(-220));
  CHECK(rest.y == doctest::Approx(-40));
  // Virtual work: force . d place = torque . d angle, for any angles and directions.
  scenes::Random random(2);
  for (int k = 0; k < 200; ++k) {
    const Vec3 a(random.uniform(-1, 1), random.uniform(-0.5, 1.2), random.uniform(0.2, 1.5)), way = random.direction();
    const ForceN force{random.direction() * 3.0};
    const double h = 1e-6;
    const Vec3 moved_m = 1e-3 * (WoodenHapticsProtocol::place(a + h * way).mm - WoodenHapticsProtocol::place(a - h * way).mm) / (2 * h);
    CHECK(glm::dot(force.N, moved_m) == doctest::Approx(glm::dot(WoodenHapticsProtocol::torques(a, force), way)).epsilon(1e-6));
  }
}

TEST_CASE("WoodenHaptics: 2000 counts turn a motor once, no motor gets more than 3 A, and NaN gives none") {
  WoodenHapticsProtocol wood;
  DevicePose pose;
  // A quarter of a turn of the second link's body: 12 x 500 counts of its motor, which turns the other way.
  Report report(8);
  putInt16(report, 2, -6000);
  CHECK(wood.take(report, pose));
  CHECK(pose.position.mm.z == doctest::Approx(205 - 220));
  CHECK_FALSE(wood.take(Report(7), pose));
  std::array<std::uint8_t, 64> out{};
  CHECK(wood.give({Vec3(0, 100, 0)}, out) == 9);
  CHECK(int16At(out, 3) == 3000);  // lifts the link: the body's torque is negative, and the motor turns against it
  wood.give({Vec3(std::nan(""), 0, 0)}, out);
  for (std::size_t k = 1; k < 7; ++k) CHECK(out[k] == 0);
}

TEST_CASE("open layout: figures come out of the feature report; one that is short, of another version or without a unit is refused") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  const auto begin = [&](Report feature, DeviceInfo& info) {
    wire->feature = std::move(feature);
    WirePort port(wire);
    return OpenProtocol().begin(port, info);
  };
  DeviceInfo info;
  CHECK_FALSE(begin(of(firmware.description()), info));
  CHECK(info.resolution_mm == doctest::Approx(0.005));
  CHECK(info.max_force_N == 4.0);
  CHECK(info.continuous_force_N == 1.2);
  CHECK(info.workspace_mm == Vec3(180, 140, 100));
  CHECK(info.max_stiffness_N_per_mm == doctest::Approx(0.6));
  CHECK(info.damping_N_s_per_m == doctest::Approx(0.15));
  CHECK(info.delay_s == doctest::Approx(0.0015));
  CHECK(info.gives_force);
  Report bad = of(firmware.description());
  bad[1] = 'X';
  CHECK(begin(bad, info));
  bad = of(firmware.description());
  bad[5] = 9;
  CHECK(begin(bad, info)->message.find("another version") != std::string::npos);
  bad = of(firmware.description());
  bad[6] = bad[7] = 0;
  CHECK(begin(bad, info));
  CHECK(begin(Report(10), info));
  CHECK(begin(Report(), info)->remedy.find("device-protocol") != std::string::npos);
}

TEST_CASE("open layout: places and forces go through the reports to a step of 5 um and of 1 mN; status becomes trouble and heat") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  WirePort port(wire);
  OpenProtocol open;
  DeviceInfo info;
  REQUIRE_FALSE(open.begin(port, info));
  DevicePose pose;
  const Report report = of(firmware.tick({12.345, -7, 0.0049}, 2));
  CHECK(open.take(report, pose));
  CHECK_FALSE(open.take(report, pose));  // the same number: nothing new
  CHECK(glm::distance(pose.position.mm, Vec3(12.345, -7, 0.005)) < 1e-9);
  CHECK(pose.buttons == 2);
  std::array<std::uint8_t, 64> out{};
  const std::size_t size = open.give({Vec3(1.2344, -0.5, 0)}, out);
  firmware.take({out.data(), size});
  CHECK(glm::distance(firmware.force_N(), Vec3(1.234, -0.5, 0)) < 1e-9);
  firmware.hot = true;
  open.take(of(firmware.tick({})), pose);
  CHECK(pose.motor_heat == 1.0f);
  firmware.fault = true;
  open.take(of(firmware.tick({})), pose);
  CHECK(pose.trouble);
  open.give({Vec3(std::nan(""), 0, 0)}, out);
  CHECK(out[9] == 0);
}

TEST_CASE("the reference firmware goes without force after 50 ms of silence, and says so, until the next report") {
  test::OpenFirmware firmware;
  Report force(11);
  force[0] = 2, force[9] = 1, force[10] = 50;
  putInt16(force, 3, 1000);
  firmware.take(force);
  for (int k = 0; k < 50; ++k) firmware.tick({});
  CHECK(firmware.force_N().x == 1.0);
  CHECK((firmware.tick({})[22] & open_layout::kWatchdogTripped) != 0);
  CHECK(firmware.force_N() == Vec3(0));
  firmware.take(force);
  CHECK(firmware.force_N().x == 1.0);
}
