// HID devices: what reports mean, garbage and short ones included; and the device's own thread over a port that a test
// holds the other end of.
#include "engine/device/hid/hid_device.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <deque>
#include <mutex>

#include "engine/bench/scenes.h"
#include "engine/device/device_model.h"
#include "engine/device/hid/play_station.h"
#include "engine/device/hid/open_device.h"
#include "engine/device/hid/space_mouse.h"
#include "engine/device/hid/wooden_haptics.h"
#include "tests/device/open_firmware.h"

using namespace moltact;

namespace {

using Report = std::vector<std::uint8_t>;

// The far end of a port.
struct Wire {
  std::mutex mutex;
  std::deque<Report> to_host;
  std::vector<Report> from_host;
  bool plugged = true;
  std::atomic<int> write_ms{0};  // how long a report out blocks
  Report feature;

  void send(Report report) {
    const std::lock_guard lock(mutex);
    to_host.push_back(std::move(report));
  }
  std::size_t written() {
    const std::lock_guard lock(mutex);
    return from_host.size();
  }
  Report last() {
    const std::lock_guard lock(mutex);
    return from_host.empty() ? Report() : from_host.back();
  }
  void plug(bool in) {
    const std::lock_guard lock(mutex);
    plugged = in;
  }
};

class WirePort final : public HidPort {
 public:
  explicit WirePort(std::shared_ptr<Wire> wire) : wire_(std::move(wire)) {}
  int read(std::span<std::uint8_t> report, int wait_ms) override {
    {
      const std::lock_guard lock(wire_->mutex);
      if (!wire_->plugged) return -1;
      if (!wire_->to_host.empty()) {
        const Report next = wire_->to_host.front();
        wire_->to_host.pop_front();
        std::copy_n(next.begin(), std::min(next.size(), report.size()), report.begin());
        return int(std::min(next.size(), report.size()));
      }
    }
    if (wait_ms) std::this_thread::sleep_for(std::chrono::microseconds(200));
    return 0;
  }
  bool write(std::span<const std::uint8_t> report) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(wire_->write_ms));
    const std::lock_guard lock(wire_->mutex);
    if (!wire_->plugged) return false;
    wire_->from_host.emplace_back(report.begin(), report.end());
    return true;
  }
  int feature(std::span<std::uint8_t> report) override {
    const std::lock_guard lock(wire_->mutex);
    if (wire_->feature.empty()) return -1;
    std::copy(wire_->feature.begin(), wire_->feature.end(), report.begin());
    return int(wire_->feature.size());
  }

 private:
  std::shared_ptr<Wire> wire_;
};

HidDevice::Opener over(std::shared_ptr<Wire> wire) {
  return [wire](const HidDevice::Accept& accept) -> Expected<std::unique_ptr<HidPort>> {
    {
      const std::lock_guard lock(wire->mutex);
      if (!wire->plugged) return Problem{"", 0, 0, "not there", ""};
    }
    std::unique_ptr<HidPort> port = std::make_unique<WirePort>(wire);
    if (const auto problem = accept(*port)) return *problem;
    return port;
  };
}

// Waits until `done`, at most some seconds; what it waits for is checked afterwards.
template <class Done>
void waitFor(Done done) {
  for (int k = 0; k < 5000 && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

Report of(const auto& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace

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

TEST_CASE("WoodenHaptics: no force until the links were held upright and the person said so; where they were then is the place at rest, and it is "
          "asked again when it was opened anew") {
  const auto wire = std::make_shared<Wire>();
  auto opened = HidDevice::open(over(wire), std::make_unique<WoodenHapticsProtocol>(), woodenHapticsInfo());
  REQUIRE(opened);
  Device& device = **opened;
  const Vec3 rest = WoodenHapticsProtocol::place(Vec3(0)).mm;
  CHECK(device.read(0.001).trouble);
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
    CHECK(device.read(0.001).trouble);
    const std::uint32_t placements = device.read(0.001).placements;
    device.calibrate();
    waitFor([&] { return !device.read(0.001).trouble; });
    CHECK_FALSE(device.read(0.001).trouble);
    CHECK(device.read(0.001).placements == placements + 1);
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
    CHECK(device.read(0.001).trouble);
  }
}

TEST_CASE("another device of the open layout is plugged in than the one that was pulled out: its own figures hold, and the room is its own") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  DeviceInfo known;
  known.name = "Built";
  auto opened = HidDevice::open(over(wire), std::make_unique<OpenProtocol>(), known);
  REQUIRE(opened);
  Device& device = **opened;
  const DeviceInfo& first = device.info();
  CHECK(first.max_force_N == 4.0);
  wire->plug(false);
  waitFor([&] { return !device.read(0.001).connected; });
  Report weaker = wire->feature;
  putInt16(weaker, 8, 900);    // 0.9 N
  putInt16(weaker, 10, 300);
  putInt16(weaker, 12, 60);    // 60 mm wide
  wire->feature = weaker;
  wire->plug(true);
  waitFor([&] { return device.read(0.001).connected; });
  CHECK(device.info().max_force_N == 0.9);
  CHECK(device.info().continuous_force_N == 0.3);
  CHECK(device.info().workspace_mm.x == 60);
  CHECK(device.info().name == "Built");
  CHECK(first.max_force_N == 4.0);  // who still reads the old ones reads them whole
}

TEST_CASE("open layout: a fault and a missing calibration are told in words, and the device is not ready meanwhile") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  auto opened = HidDevice::open(over(wire), std::make_unique<OpenProtocol>(), DeviceInfo());
  REQUIRE(opened);
  Device& device = **opened;
  CHECK(device.status().ready);
  firmware.fault = true;
  wire->send(of(firmware.tick({})));
  waitFor([&] { return !device.status().ready; });
  CHECK(device.status().text.find("reports a fault") != std::string::npos);
  CHECK_FALSE(device.status().asks_calibrate);
  CHECK(device.read(0.001).trouble);
}

TEST_CASE("the age of a place grows from when it came, and holds the time that a force waits to be written, 5 ms here; a device without force has none") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  auto opened = HidDevice::open(over(wire), std::make_unique<OpenProtocol>(), DeviceInfo());
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
  auto mouse = HidDevice::open(over(cap), std::make_unique<SpaceMouseProtocol>(), DeviceInfo());
  REQUIRE(mouse);
  cap->send({3, 2});
  waitFor([&] { return (*mouse)->read(0.001).buttons == 2; });
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  CHECK((*mouse)->read(0.001).age_s == 0.0f);
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

TEST_CASE("a HID device: places arrive, forces go out, silence of the loop ends the force, unplugging is told and plugging in mends it") {
  test::OpenFirmware firmware;
  const auto wire = std::make_shared<Wire>();
  wire->feature = of(firmware.description());
  DeviceInfo known;
  known.name = "Built";
  auto opened = HidDevice::open(over(wire), std::make_unique<OpenProtocol>(), known);
  REQUIRE(opened);
  Device& device = **opened;
  CHECK(device.info().name == "Built");
  wire->send({1, 2, 3});  // short
  wire->send(Report(64, 0xEE));
  wire->send(of(firmware.tick({10, 0, 0})));
  DevicePose pose;
  bool fresh = false;
  waitFor([&] { pose = device.read(0.001); fresh = fresh || pose.fresh; return pose.position.mm.x == 10; });
  CHECK(pose.position.mm == Vec3(10, 0, 0));
  CHECK(fresh);
  CHECK_FALSE(device.read(0.001).fresh);  // nothing new has come since
  CHECK(device.status().ready);

  waitFor([&] { device.write({Vec3(1, 0, 0)}); const Report r = wire->last(); return r.size() == 11 && int16At(r, 3) == 1000; });
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
  CHECK(pose.placements == 1);
  wire->send(of(firmware.tick({20, 0, 0})));
  waitFor([&] { return device.read(0.001).position.mm.x == 20; });
  CHECK(device.read(0.001).position.mm.x == 20);
  waitFor([&] { device.write({Vec3(1, 0, 0)}); return int16At(wire->last(), 3) == 1000; });
  opened->reset();
  CHECK(int16At(wire->last(), 3) == 0);  // closed without force
}
