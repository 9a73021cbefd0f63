// The last force a device receives is zero: every driver with every way to end. The stand-ins record the last write and
// its time. Ways that end the process are in dying_hand_test.cpp. (Ordered after omni_device_test.cpp, whose first test
// requires that the library is not loaded yet.)
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "engine/device/driver.h"
#include "engine/device/hid/open_layout.h"
#include "engine/device/hid/play_station.h"
#include "engine/device/hid/space_mouse.h"
#include "engine/device/hid/wooden_haptics.h"
#include "engine/device/packet/packet_device.h"
#include "engine/device/packet/report_bytes.h"
#include "engine/device/simulated_device.h"
#include "engine/platform/force_inhibit.h"
#include "tests/device/omni/stand_in.h"
#include "tests/device/open_firmware.h"
#include "tests/device/wire_port.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr ForceN kPush{{0.0, 0.6, 0.8}};

// A driver's device over its stand-in, given a force of 1 N until something ends it.
class Bench {
 public:
  virtual ~Bench() = default;
  virtual Device* device() = 0;
  virtual void close() = 0;
  /// Until the stand-in has the force.
  virtual void press() = 0;
  /// The loop ticks once, and asks for the force again.
  virtual void tick() = 0;
  /// A millisecond in which the loop is silent.
  virtual void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }
  /// The magnitude of the last output: newton, or the device's equivalent.
  virtual double last() const = 0;
  /// Of what was written since the last press().
  virtual int forcedSince() const { return 0; }
  /// The way out of that name; false: this driver has none of it.
  virtual bool doIt(const std::string& way) = 0;
};

class OmniBench final : public Bench, private ClockListener {
 public:
  OmniBench() : device_(opened()) { CHECK(device_->startClock(*this)); }
  Device* device() override { return device_.get(); }
  void close() override { device_.reset(); }
  void press() override {
    omni_.step(5);
    REQUIRE(omni_.force() == doctest::Approx(1.0));
    REQUIRE(omni_.driven() == doctest::Approx(1.0));
  }
  void tick() override { omni_.step(1); }
  double last() const override { return omni_.force(); }
  double driven() const { return omni_.driven(); }
  const StandIn& standIn() const { return omni_; }
  bool doIt(const std::string& way) override {
    // Every error that ends the connection, as it is found when the frame begins and when it ends.
    static const std::map<std::string, std::uint32_t> kErrors{{"bad handle", hd::kBadHandle},
                                                              {"device fault", hd::kDeviceFault},
                                                              {"already initiated", hd::kAlreadyInitiated},
                                                              {"comm error", hd::kCommError},
                                                              {"comm config", hd::kCommConfig},
                                                              {"timer error", hd::kTimerError},
                                                              {"invalid priority", hd::kInvalidPriority},
                                                              {"scheduler full", hd::kSchedulerFull}};
    if (way == "calibration lost") return omni_.calibration(hd::kNeedsManualInput, hd::kInkwell), true;
    if (way == "unplugged") return omni_.attach(false), true;
    for (const auto& [name, code] : kErrors) {
      if (way == name) return omni_.error(code), true;
      if (way == name + " at the frame's end") return omni_.errorAtEnd(code), true;
    }
    if (way == "stop") return stops_ = true;
    return false;
  }

 private:
  void onDeviceTick() noexcept override {
    const DevicePose pose = device_->read(0.001);
    stops_ ? device_->stop() : device_->write(pose.fault || !pose.connected ? ForceN{} : kPush);
  }
  StandIn omni_;
  std::unique_ptr<OmniDevice> device_;
  bool stops_ = false;
};

class HidBench final : public Bench {
 public:
  HidBench(std::unique_ptr<PacketProtocol> protocol, DeviceInfo info, Report place, double (*size)(const Report&),
           Report feature = {})
      : place_(std::move(place)), size_(size) {
    wire_->feature = std::move(feature);
    auto opened = PacketDevice::open(over(wire_), std::move(protocol), std::move(info));
    REQUIRE(opened);
    device_ = std::move(*opened);
  }
  Device* device() override { return device_.get(); }
  void close() override { device_.reset(); }
  void press() override {
    waitFor([&] {
      wire_->send(place_);
      if (device_->status().asks_calibrate) device_->calibrate();
      tick();
      return last() > 0.0;
    });
    REQUIRE(last() > 0.0);
    const std::lock_guard lock(wire_->mutex);
    before_ = wire_->from_host.size();
  }
  void tick() override {
    if (device_) stops_ ? device_->stop() : device_->write(kPush);
    wait();
  }
  double last() const override {
    const Report report = wire_->last();
    return report.empty() ? 0.0 : size_(report);
  }
  int forcedSince() const override {
    const std::lock_guard lock(wire_->mutex);
    return int(std::count_if(wire_->from_host.begin() + std::ptrdiff_t(before_), wire_->from_host.end(),
                             [&](const Report& r) { return size_(r) > 0.0; }));
  }
  bool doIt(const std::string& way) override {
    const std::lock_guard lock(wire_->mutex);
    before_ = wire_->from_host.size();
    if (way == "no more reads") return wire_->no_read = true;
    if (way == "a stop whose write fails") return wire_->no_write_once = stops_ = true;
    if (way == "an exception") return wire_->throws_once = true;
    if (way == "stop") return stops_ = true;
    return false;
  }
  std::size_t written() const { return wire_->written(); }

 private:
  std::shared_ptr<Wire> wire_ = std::make_shared<Wire>();
  Report place_;
  double (*size_)(const Report&);
  std::unique_ptr<Device> device_;
  std::size_t before_ = 0;
  bool stops_ = false;
};

class SimulatedBench final : public Bench {
 public:
  Device* device() override { return device_.get(); }
  void close() override { device_.reset(); }
  void press() override {
    tick();
    REQUIRE(last() == doctest::Approx(1.0));
  }
  void tick() override {
    if (device_) stops_ ? device_->stop() : device_->write(kPush);
  }
  double last() const override { return glm::length(model_->held().N); }
  bool doIt(const std::string& way) override {
    if (way == "stop") return stops_ = true;
    if (way == "unplugged") return device_->plug(false), true;
    return false;
  }

 private:
  std::unique_ptr<SimulatedDevice> device_ = std::make_unique<SimulatedDevice>(DeviceParameters{.delay_ticks = 0});
  std::shared_ptr<const DeviceModel> model_ = device_->model();
  bool stops_ = false;
};

double currents(const Report& r) { return std::abs(int16At(r, 1)) + std::abs(int16At(r, 3)) + std::abs(int16At(r, 5)); }
double openForce(const Report& r) {
  return r[9] ? std::abs(int16At(r, 3)) + std::abs(int16At(r, 5)) + std::abs(int16At(r, 7)) : 0.0;
}
template <const PadLayout& kPad>
double rumble(const Report& r) {
  return r[kPad.weak_motor] + r[kPad.strong_motor];
}
double nothing(const Report&) { return 1.0; }  // whatever is written is too much

struct Row {
  std::string driver;
  bool gives;
  std::unique_ptr<Bench> (*make)();
};
// One row a driver.
const Row kRows[] = {
    {"omni", true, [] { return std::unique_ptr<Bench>(new OmniBench); }},
    {"woodenhaptics", true,
     [] {
       return std::unique_ptr<Bench>(
           new HidBench(std::make_unique<WoodenHapticsProtocol>(), woodenHapticsInfo(), Report(8), currents));
     }},
    {"open", true,
     [] {
       OpenFirmware firmware;
       return std::unique_ptr<Bench>(new HidBench(std::make_unique<OpenLayoutProtocol>(), DeviceInfo(),
                                                  of(firmware.tick({})), openForce, of(firmware.description())));
     }},
    {"open-tcp", true,  // the same protocol; what its own port does is in tcp_device_test.cpp
     [] {
       OpenFirmware firmware;
       return std::unique_ptr<Bench>(new HidBench(std::make_unique<OpenLayoutProtocol>(), DeviceInfo(),
                                                  of(firmware.tick({})), openForce, of(firmware.description())));
     }},
    {"gamepad", true,
     [] {
       Report state(64, 128);
       state[0] = 1;
       return std::unique_ptr<Bench>(
           new HidBench(std::make_unique<PlayStationProtocol>(kDualShock4), DeviceInfo(), state, rumble<kDualShock4>));
     }},
    {"dualsense", true,
     [] {
       Report state(64, 128);
       state[0] = 1;
       return std::unique_ptr<Bench>(
           new HidBench(std::make_unique<PlayStationProtocol>(kDualSense), DeviceInfo(), state, rumble<kDualSense>));
     }},
    {"simulated", true, [] { return std::unique_ptr<Bench>(new SimulatedBench); }},
    {"spacemouse", false,
     [] {
       return std::unique_ptr<Bench>(
           new HidBench(std::make_unique<SpaceMouseProtocol>(), DeviceInfo(), Report(13, 1), nothing));
     }},
    {"mouse", false, nullptr},  // no device of the system
};

const std::vector<std::string> kWays = [] {
  std::vector<std::string> all{
      "stop", "unplugged", "calibration lost", "no more reads", "a stop whose write fails", "an exception"};
  for (const char* error : {"bad handle", "device fault", "already initiated", "comm error", "comm config",
                            "timer error", "invalid priority", "scheduler full"}) {
    all.emplace_back(error);
    all.push_back(std::string(error) + " at the frame's end");
  }
  return all;
}();

double ms(std::chrono::steady_clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

}  // namespace

TEST_CASE("every driver is in the table of those whose last force is checked") {
  std::set<std::string_view> there, looked_at;
  for (const DeviceDriver& driver : deviceDrivers()) there.insert(driver.name);
  for (const Row& row : kRows) looked_at.insert(row.driver);
  CHECK(there == looked_at);
}

TEST_CASE(
    "every driver by every way out: within two ticks the last that was written is no force, and none follows though "
    "the loop continues asking") {
  double worst_ms = 0;
  int ways = 0;
  for (const Row& row : kRows) {
    if (!row.gives) continue;
    for (const std::string& way : kWays) {
      const auto bench = row.make();
      CAPTURE(row.driver);
      CAPTURE(way);
      bench->press();
      const auto began = std::chrono::steady_clock::now();
      if (!bench->doIt(way)) continue;
      ++ways;
      // The device's own thread takes its time on a busy machine: what it writes is counted, not the loop's ticks.
      const bool own_thread = dynamic_cast<HidBench*>(bench.get()) != nullptr;
      int ticks = 0;
      for (; ticks < (own_thread ? 1000 : 2) && bench->last() > 0.0; ++ticks) bench->tick();
      if (own_thread) worst_ms = std::max(worst_ms, ms(std::chrono::steady_clock::now() - began));
      CHECK(bench->last() == 0.0);
      CHECK(bench->forcedSince() <= 2);
      if (way == "an exception") continue;  // it is reopened and may receive force again
      for (int k = 0; k < 20; ++k) bench->tick();
      CHECK(bench->last() == 0.0);
      bench->close();
      CHECK(bench->last() == 0.0);
    }
  }
  CHECK(ways >= 3 * 4 + 2 + 18);
  MESSAGE(ways << " ways; over HID at most " << worst_ms << " ms of the wall's clock");
}

TEST_CASE("every driver: a device that is destroyed under force was given none last") {
  for (const Row& row : kRows) {
    if (!row.gives) continue;
    CAPTURE(row.driver);
    const auto bench = row.make();
    bench->press();
    bench->close();
    CHECK(bench->last() == 0.0);
    CHECK(bench->forcedSince() <= 2);
  }
}

TEST_CASE(
    "every driver: while all force is held, as a signal's handler does, none is written, and after it the loop gives "
    "again") {
  for (const Row& row : kRows) {
    if (!row.gives || row.driver == "simulated") continue;  // the simulated one is not a real device
    CAPTURE(row.driver);
    const auto bench = row.make();
    bench->press();
    inhibitForce(InhibitReason::Stopped);
    const bool hid = dynamic_cast<HidBench*>(bench.get());
    for (int k = 0; k < (hid ? 1000 : 2) && bench->last() > 0.0; ++k) bench->tick();
    CHECK(bench->last() == 0.0);
    for (int k = 0; k < 20; ++k) bench->tick();
    CHECK(bench->last() == 0.0);
    permitForce(InhibitReason::Stopped);
    for (int k = 0; k < 1000 && bench->last() == 0.0; ++k) bench->tick();
    CHECK(bench->last() > 0.0);
  }
}

TEST_CASE("every HID device: a loop that has been silent for 20 ms gives no force any more") {
  for (const Row& row : kRows) {
    if (!row.gives) continue;
    const auto bench = row.make();
    if (!dynamic_cast<HidBench*>(bench.get())) continue;
    CAPTURE(row.driver);
    bench->press();
    const auto began = std::chrono::steady_clock::now();
    for (int k = 0; k < 3000 && bench->last() > 0.0; ++k) bench->wait();
    CHECK(bench->last() == 0.0);
    MESSAGE(row.driver << ": " << ms(std::chrono::steady_clock::now() - began) << " ms");
  }
}

TEST_CASE("a device without force is never written to, whatever is asked and however it ends") {
  for (const Row& row : kRows) {
    if (row.gives || !row.make) continue;
    CAPTURE(row.driver);
    const auto bench = row.make();
    for (int k = 0; k < 30; ++k) bench->tick();
    bench->doIt("no more reads");
    for (int k = 0; k < 10; ++k) bench->tick();
    bench->close();
    const auto* const wire = dynamic_cast<const HidBench*>(bench.get());
    REQUIRE_MESSAGE(wire, "a forceless device that speaks no packets needs a bench that counts what is written");
    CHECK(wire->written() == 0);
  }
}

TEST_CASE("Omni: an error of the frame's end switches the motors off in that tick, and the next one writes no force") {
  OmniBench bench;
  bench.press();
  bench.standIn().errorAtEnd(hd::kCommError);
  bench.tick();
  CHECK(bench.driven() == 0.0);
  bench.tick();
  CHECK(bench.last() == 0.0);
}

TEST_CASE("Omni: a calibration that is lost ends the force in that very tick, whenever it is lost") {
  for (int tick = 0; tick < 12; ++tick) {
    CAPTURE(tick);
    OmniBench bench;
    bench.press();
    for (int k = 0; k < tick; ++k) bench.tick();
    bench.standIn().calibration(hd::kNeedsManualInput, hd::kInkwell);
    bench.tick();
    CHECK(bench.last() == 0.0);
  }
}

TEST_CASE(
    "Omni: where its callback no longer comes, or does not come back, the motors are switched off after 20 ms by "
    "another thread, and on "
    "again, without force, when it does") {
  struct Slow final : ClockListener {
    void onDeviceTick() noexcept override {
      device->write(cut.load() ? ForceN{} : kPush);
      if (const int wait = sleep_ms.exchange(0)) std::this_thread::sleep_for(std::chrono::milliseconds(wait));
      cut.store(cut.load() || device->read(0.001).fault);
    }
    Device* device = nullptr;
    std::atomic<int> sleep_ms{0};
    std::atomic<bool> cut{false};
  };
  for (const bool stands : {true, false}) {
    CAPTURE(stands);
    const StandIn omni;
    auto open = OmniDevice::open();  // by the wall's clock
    REQUIRE(open);
    const std::unique_ptr<OmniDevice> device = std::move(*open);
    Slow loop;
    loop.device = device.get();
    REQUIRE(device->startClock(loop));
    std::thread late;
    omni.step(5);
    REQUIRE(omni.driven() == doctest::Approx(1.0));
    const auto began = std::chrono::steady_clock::now();
    if (stands)
      omni.stopClock(true);
    else
      loop.sleep_ms = 200, late = std::thread([&] { omni.step(1); });
    while (omni.driven() > 0.0 && ms(std::chrono::steady_clock::now() - began) < 2000)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    CHECK(omni.driven() == 0.0);
    MESSAGE(std::string(stands ? "no callback: " : "a callback that hangs: ")
            << ms(std::chrono::steady_clock::now() - began) << " ms");
    if (late.joinable()) late.join();
    omni.stopClock(false);
    const auto on = [&] { return omni.call<bool()>("standInForcesOn")(); };
    for (int k = 0; k < 2000 && !on(); ++k) {
      omni.step(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(on());
    CHECK(loop.cut);              // it was reported as a fault
    CHECK(omni.driven() == 0.0);  // and came back without force
    device->stopClock();
  }
}
