// Parsing of reports from haptic HID devices, including invalid and short ones of every kind.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/bench/scenes.h"
#include "engine/device/hid/open_layout.h"
#include "engine/device/hid/play_station.h"
#include "engine/device/hid/space_mouse.h"
#include "engine/device/hid/wooden_haptics.h"
#include "engine/device/packet/report_bytes.h"
#include "tests/device/open_firmware.h"
#include "tests/device/wire_port.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "10 000 reports of random length and bytes leave every protocol's place finite and within what 16 bits can say; "
    "seed 1") {
  scenes::Random random(1);
  SpaceMouseProtocol mouse;
  WoodenHapticsProtocol wood;
  OpenLayoutProtocol open;
  PlayStationProtocol pad;
  DevicePose pose;
  std::array<std::uint8_t, 64> out{};
  for (int k = 0; k < 10'000; ++k) {
    Report report(std::size_t(random.uniform(0, 65)));
    for (auto& byte : report) byte = std::uint8_t(random.uniform(0, 256));
    if (k % 2 && !report.empty()) report[0] = std::uint8_t(1 + k / 2 % 3);
    for (PacketProtocol* one : {static_cast<PacketProtocol*>(&mouse), static_cast<PacketProtocol*>(&wood),
                                static_cast<PacketProtocol*>(&open), static_cast<PacketProtocol*>(&pad)}) {
      one->parseReport(report, pose);
      one->advance(0.001, pose);
      REQUIRE(finite(pose.position.mm));
      REQUIRE(glm::length(pose.position.mm) < 1000);
      one->encode({.force = {Vec3(random.uniform(-9, 9), std::nan(""), 0)}}, out);
    }
  }
}

TEST_CASE(
    "WoodenHaptics: at rest the handle is 220 mm behind and 40 mm under the middle, and work is the same at motor and "
    "hand") {
  const Vec3 rest = WoodenHapticsProtocol::place(Vec3(0)).mm;
  CHECK(rest.z == doctest::Approx(-220));
  CHECK(rest.y == doctest::Approx(-40));
  // Virtual work: force . d place = torque . d angle, for any angles and directions.
  scenes::Random random(2);
  for (int k = 0; k < 200; ++k) {
    const Vec3 a(random.uniform(-1, 1), random.uniform(-0.5, 1.2), random.uniform(0.2, 1.5)), way = random.direction();
    const ForceN force{random.direction() * 3.0};
    const double h = 1e-6;
    const Vec3 moved_m =
        1e-3 * (WoodenHapticsProtocol::place(a + h * way).mm - WoodenHapticsProtocol::place(a - h * way).mm) / (2 * h);
    CHECK(glm::dot(force.N, moved_m) ==
          doctest::Approx(glm::dot(WoodenHapticsProtocol::torques(a, force), way)).epsilon(1e-6));
  }
}

TEST_CASE("WoodenHaptics: 2000 counts turn a motor once, no motor gets more than 3 A, and NaN gives none") {
  WoodenHapticsProtocol wood;
  DevicePose pose;
  // A quarter of a turn of the second link's body: 12 x 500 counts of its motor, which turns the other way.
  Report report(8);
  putInt16(report, 2, -6000);
  CHECK(wood.parseReport(report, pose));
  CHECK(pose.position.mm.z == doctest::Approx(205 - 220));
  CHECK_FALSE(wood.parseReport(Report(7), pose));
  std::array<std::uint8_t, 64> out{};
  CHECK(wood.encode({.force = {Vec3(0, 100, 0)}}, out) == 9);
  CHECK(int16At(out, 3) == 3000);  // lifts the link: the body's torque is negative, and the motor turns against it
  wood.encode({.force = {Vec3(std::nan(""), 0, 0)}}, out);
  for (std::size_t k = 1; k < 7; ++k) CHECK(out[k] == 0);
}

TEST_CASE(
    "open layout: figures come out of the feature report; one that is short, of another version or without a unit is "
    "refused") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  const auto begin = [&](Report feature, DeviceInfo& info) {
    wire->feature = std::move(feature);
    WirePort port(wire);
    return OpenLayoutProtocol().begin(port, info);
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

TEST_CASE(
    "open layout: places and forces go through the reports to a step of 5 um and of 1 mN; status becomes fault and "
    "heat") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  WirePort port(wire);
  OpenLayoutProtocol open;
  DeviceInfo info;
  REQUIRE_FALSE(open.begin(port, info));
  DevicePose pose;
  const Report report = of(firmware.tick({12.345, -7, 0.0049}, 2));
  CHECK(open.parseReport(report, pose));
  CHECK_FALSE(open.parseReport(report, pose));  // the same number: nothing new
  CHECK(glm::distance(pose.position.mm, Vec3(12.345, -7, 0.005)) < 1e-9);
  CHECK(pose.buttons == 2);
  std::array<std::uint8_t, 64> out{};
  const std::size_t size = open.encode({.force = {Vec3(1.2344, -0.5, 0)}}, out);
  firmware.take({out.data(), size});
  CHECK(glm::distance(firmware.force_N(), Vec3(1.234, -0.5, 0)) < 1e-9);
  firmware.hot = true;
  open.parseReport(of(firmware.tick({})), pose);
  CHECK(pose.motor_heat == 1.0f);
  firmware.fault = true;
  open.parseReport(of(firmware.tick({})), pose);
  CHECK(pose.fault);
  open.encode({.force = {Vec3(std::nan(""), 0, 0)}}, out);
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
