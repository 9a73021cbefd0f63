// The thread of a packet device, with a port whose other end the test controls: positions, forces, text, plugging, the
// age of a position.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "engine/device/hid/open_layout.h"
#include "engine/device/hid/space_mouse.h"
#include "engine/device/hid/wooden_haptics.h"
#include "engine/device/packet/report_bytes.h"
#include "tests/device/open_firmware.h"
#include "tests/device/wire_port.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "WoodenHaptics: no force until the links were held upright and the person said so; where they were then is the "
    "place at rest, and it is "
    "asked again when it was opened again") {
  const auto wire = std::make_shared<Wire>();
  auto opened = PacketDevice::open(over(wire), std::make_unique<WoodenHapticsProtocol>(), woodenHapticsInfo());
  REQUIRE(opened);
  Device& device = **opened;
  const Vec3 rest = WoodenHapticsProtocol::place(Vec3(0)).mm;
  CHECK(device.read(0.001).fault);
  for (int time = 0; time < 2; ++time) {
    CAPTURE(time);
    CHECK_FALSE(device.status().ready);
    CHECK(device.status().asks_calibrate);
    CHECK(device.status().text.find("Hold both links of the device upright") == 0);
    // It was switched on somewhere else: upright it counts 3000, -32000 and 500.
    Report upright(8);
    putInt16(upright, 0, 3000);
    putInt16(upright, 2, -32000);
    putInt16(upright, 4, 500);
    wire->send(upright);
    waitFor([&] { return device.read(0.001).fresh; });
    CHECK(device.read(0.001).fault);
    const std::uint32_t discontinuities = device.read(0.001).discontinuities;
    device.calibrate();
    waitFor([&] { return !device.read(0.001).fault; });
    CHECK_FALSE(device.read(0.001).fault);
    CHECK(device.read(0.001).discontinuities == discontinuities + 1);
    CHECK(device.status().ready);
    wire->send(upright);
    waitFor([&] { return glm::distance(device.read(0.001).position.mm, rest) < 1e-9; });
    CHECK(glm::distance(device.read(0.001).position.mm, rest) < 1e-9);
    // A quarter of a turn of the second link from there, over the end of what 16 bits count.
    Report turned = upright;
    putInt16(turned, 2, -32000 - 6000);
    wire->send(turned);
    waitFor([&] { return std::abs(device.read(0.001).position.mm.z + 15.0) < 1e-6; });
    CHECK(device.read(0.001).position.mm.z == doctest::Approx(205 - 220));
    wire->plug(false);
    waitFor([&] { return !device.read(0.001).connected; });
    wire->plug(true);
    waitFor([&] { return device.read(0.001).connected; });
    CHECK(device.read(0.001).fault);
  }
}

TEST_CASE(
    "another device of the open layout is plugged in than the one that was pulled out: its own figures hold, and the "
    "room is its own") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  DeviceInfo known;
  known.name = "Built";
  auto opened = PacketDevice::open(over(wire), std::make_unique<OpenLayoutProtocol>(), known);
  REQUIRE(opened);
  Device& device = **opened;
  const DeviceInfo& first = device.info();
  CHECK(first.max_force_N == 4.0);
  wire->plug(false);
  waitFor([&] { return !device.read(0.001).connected; });
  Report weaker = wire->feature;
  putInt16(weaker, 8, 900);  // 0.9 N
  putInt16(weaker, 10, 300);
  putInt16(weaker, 12, 60);  // 60 mm wide
  wire->feature = weaker;
  wire->plug(true);
  waitFor([&] { return device.read(0.001).connected; });
  CHECK(device.info().max_force_N == 0.9);
  CHECK(device.info().continuous_force_N == 0.3);
  CHECK(device.info().workspace_mm.x == 60);
  CHECK(device.info().name == "Built");
  CHECK(first.max_force_N == 4.0);  // who still reads the old ones reads them whole
}

TEST_CASE(
    "open layout: a fault and a missing calibration are reported in words, and the device is not "
    "ready meanwhile") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  auto opened = PacketDevice::open(over(wire), std::make_unique<OpenLayoutProtocol>(), DeviceInfo());
  REQUIRE(opened);
  Device& device = **opened;
  CHECK(device.status().ready);
  firmware.fault = true;
  wire->send(of(firmware.tick({})));
  waitFor([&] { return !device.status().ready; });
  CHECK(device.status().text.find("reports a fault") != std::string::npos);
  CHECK_FALSE(device.status().asks_calibrate);
  CHECK(device.read(0.001).fault);
}

TEST_CASE(
    "the age of a place grows from when it came, and holds the time that a force waits to be written, 5 ms here; a "
    "device without force has none") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  auto opened = PacketDevice::open(over(wire), std::make_unique<OpenLayoutProtocol>(), DeviceInfo());
  REQUIRE(opened);
  Device& device = **opened;
  CHECK(device.read(0.001).age_s == 0.0f);  // no place yet
  wire->send(of(firmware.tick({1, 0, 0})));
  waitFor([&] { return device.read(0.001).position.mm.x == 1; });
  const float first = device.read(0.001).age_s;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(device.read(0.001).age_s >= first + 0.02f);
  wire->write_ms = 5;
  waitFor([&] {
    device.write({Vec3(1, 0, 0)});
    wire->send(of(firmware.tick({1, 0, 0})));
    const bool waited = device.read(0.001).age_s >= 0.005f && device.read(0.001).fresh;
    return waited;
  });
  // Ages of places that have just come are small; what is left of 5 ms or more is the wait.
  double least = 1;
  for (int k = 0; k < 200; ++k) {
    device.write({Vec3(1, 0, 0)});
    wire->send(of(firmware.tick({1, 0, 0})));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    least = std::min(least, double(device.read(0.001).age_s));
  }
  CHECK(least >= 0.005);

  const auto cap = std::make_shared<Wire>();
  auto mouse = PacketDevice::open(over(cap), std::make_unique<SpaceMouseProtocol>(), DeviceInfo());
  REQUIRE(mouse);
  cap->send({3, 2});
  waitFor([&] { return (*mouse)->read(0.001).buttons == 2; });
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  CHECK((*mouse)->read(0.001).age_s == 0.0f);
}

TEST_CASE(
    "a packet device: places arrive, forces go out, silence of the loop ends the force, unplugging "
    "is reported and plugging in mends it") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  DeviceInfo known;
  known.name = "Built";
  auto opened = PacketDevice::open(over(wire), std::make_unique<OpenLayoutProtocol>(), known);
  REQUIRE(opened);
  Device& device = **opened;
  CHECK(device.info().name == "Built");
  wire->send({1, 2, 3});  // short
  wire->send(Report(64, 0xEE));
  wire->send(of(firmware.tick({10, 0, 0})));
  DevicePose pose;
  bool fresh = false;
  waitFor([&] {
    pose = device.read(0.001);
    fresh = fresh || pose.fresh;
    return pose.position.mm.x == 10;
  });
  CHECK(pose.position.mm == Vec3(10, 0, 0));
  CHECK(fresh);
  CHECK_FALSE(device.read(0.001).fresh);  // nothing new has come since
  CHECK(device.status().ready);

  waitFor([&] {
    device.write({Vec3(1, 0, 0)});
    const Report r = wire->last();
    return r.size() == 11 && int16At(r, 3) == 1000;
  });
  CHECK(int16At(wire->last(), 3) == 1000);
  waitFor([&] { return int16At(wire->last(), 3) == 0; });  // the loop is silent
  CHECK(int16At(wire->last(), 3) == 0);

  wire->plug(false);
  waitFor([&] { return !device.read(0.001).connected; });
  CHECK_FALSE(device.read(0.001).connected);
  CHECK(device.status().text.find("plug it in") != std::string::npos);
  wire->plug(true);
  waitFor([&] { return device.read(0.001).connected; });
  pose = device.read(0.001);
  CHECK(pose.connected);
  CHECK(pose.discontinuities == 1);
  wire->send(of(firmware.tick({20, 0, 0})));
  waitFor([&] { return device.read(0.001).position.mm.x == 20; });
  CHECK(device.read(0.001).position.mm.x == 20);
  waitFor([&] {
    device.write({Vec3(1, 0, 0)});
    return int16At(wire->last(), 3) == 1000;
  });
  opened->reset();
  CHECK(int16At(wire->last(), 3) == 0);  // closed without force
}

namespace {

// One report each way, six numbers of 16 bits: mN and N mm / 100.
class SixForces final : public PacketProtocol {
 public:
  bool parseReport(std::span<const std::uint8_t>, DevicePose&) noexcept override { return true; }
  std::size_t encode(const Wrench& wrench, ReportBuffer out) noexcept override {
    for (int k = 0; k < 3; ++k) {
      putInt16(out, 2 * std::size_t(k), int(std::lround(1e3 * wrench.force.N[k])));
      putInt16(out, 6 + 2 * std::size_t(k), int(std::lround(1e2 * wrench.torque_N_mm[k])));
    }
    return 12;
  }
};

}  // namespace

TEST_CASE(
    "a device of six driven degrees of freedom gets its torque with its force: 1 N and -20 N mm; none of both when it "
    "is stopped, when the loop is silent for 20 ms, and when it is closed") {
  const auto wire = std::make_shared<Wire>();
  DeviceInfo known;
  known.gives_force = true;
  known.dof_out = 6;
  auto opened = PacketDevice::open(over(wire), std::make_unique<SixForces>(), known);
  REQUIRE(opened);
  Device& device = **opened;
  const auto numbers = [&] {
    const Report r = wire->last();
    std::array<int, 6> out{};
    for (std::size_t k = 0; k < 6 && r.size() == 12; ++k) out[k] = int16At(r, 2 * k);
    return out;
  };
  const Wrench wrench{.force = {Vec3(1, 0, 0)}, .torque_N_mm = Vec3(0, -20, 0)};
  const std::array<int, 6> given{1000, 0, 0, 0, -2000, 0}, none{};
  const auto give = [&] {
    waitFor([&] {
      device.writeWrench(wrench);
      return numbers() == given;
    });
    CHECK(numbers() == given);
  };
  give();
  waitFor([&] {
    device.stop();
    return numbers() == none;
  });
  CHECK(numbers() == none);
  give();
  waitFor([&] { return numbers() == none; });  // the loop is silent
  CHECK(numbers() == none);
  // A force alone has no torque.
  waitFor([&] {
    device.write({Vec3(0, 0, 2)});
    return numbers()[2] == 2000;
  });
  CHECK(numbers() == std::array<int, 6>{0, 0, 2000, 0, 0, 0});
  give();
  opened->reset();
  CHECK(numbers() == none);
}

TEST_CASE(
    "without a thread a tick takes what has come and gives its force at once, the 20 ms between two frames count as "
    "age, "
    "and after an unplugging the next ticks open it again") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  auto opened = PacketDevice::open(over(wire), std::make_unique<OpenLayoutProtocol>(), DeviceInfo(), false);
  REQUIRE(opened);
  Device& device = **opened;
  const auto force_mN = [&] {
    const Report report = wire->last();
    return report.size() == 11 && report[0] == 2 ? int16At(report, 3) : -1;
  };
  const auto frame = [&] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  for (const double x_mm : {1.0, 2.0, 3.0}) {
    frame();
    wire->send(of(firmware.tick({x_mm, 0, 0})));
    const DevicePose pose = device.read(0.001);
    CHECK(pose.position.mm.x == doctest::Approx(x_mm).epsilon(0.01));
    CHECK(pose.fresh);
    CHECK(pose.age_s >= 0.020f);
    const std::size_t before = wire->written();
    device.write({Vec3(0.25 * x_mm, 0, 0)});
    CHECK(wire->written() == before + 1);
    CHECK(force_mN() == int(std::lround(250 * x_mm)));
    // The frame's next tick: nothing new has come, and the frame's way still counts.
    const DevicePose again = device.read(0.001);
    CHECK_FALSE(again.fresh);
    CHECK(again.age_s >= 0.020f);
  }
  device.stop();
  CHECK(force_mN() == 0);
  CHECK(wire->last()[9] == 0);  // the motors are off

  device.write({Vec3(1, 0, 0)});
  CHECK(force_mN() == 1000);
  const std::uint32_t discontinuities = device.read(0.001).discontinuities;
  wire->plug(false);
  CHECK_FALSE(device.read(0.001).connected);
  device.write({Vec3(1, 0, 0)});  // into nothing
  CHECK_FALSE(device.status().ready);
  wire->plug(true);
  waitFor([&] { return device.read(0.001).connected; });
  CHECK(device.read(0.001).discontinuities == discontinuities + 1);
  device.write({Vec3(1, 0, 0)});
  CHECK(force_mN() == 1000);
  wire->no_write_once = true;
  device.write({Vec3(1, 0, 0)});
  CHECK_FALSE(device.read(0.001).connected);
  CHECK(force_mN() == 0);  // the last thing tried ends the force
  waitFor([&] { return device.read(0.001).connected; });
  device.write({Vec3(1, 0, 0)});
  opened->reset();
  CHECK(force_mN() == 0);
  CHECK(wire->last()[9] == 0);
}

TEST_CASE("of 130 reports that wait, each is parsed by the third tick: a place that only the 65th brings is not lost") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  auto opened = PacketDevice::open(over(wire), std::make_unique<OpenLayoutProtocol>(), DeviceInfo(), false);
  REQUIRE(opened);
  Device& device = **opened;
  for (int k = 1; k <= 64; ++k) wire->send({1, 2, 3});  // short: no place
  wire->send(of(firmware.tick({10, 0, 0})));
  for (int k = 66; k <= 130; ++k) wire->send({1, 2, 3});
  for (int tick = 0; tick < 3; ++tick) device.read(0.001);
  CHECK(device.read(0.001).position.mm == Vec3(10, 0, 0));
  CHECK(wire->to_host.empty());
}
