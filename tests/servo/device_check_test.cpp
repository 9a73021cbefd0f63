// The check of a device, with the simulated stylus, whose hand presses on what it is offered.
#include "engine/servo/device_check.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

#include "engine/device/simulated_device.h"
#include "engine/servo/faulty_device.h"
#include "engine/servo/safety_limits.h"

using namespace moltact;

namespace {

// A stylus that loses its plug after some reads.
class LoseableDevice final : public Device {
 public:
  const DeviceInfo& info() const noexcept override { return inner_.info(); }
  DevicePose read(double dt_s) noexcept override {
    if (++reads_ == 60) inner_.plug(false);
    return inner_.read(dt_s);
  }
  void write(ForceN force) noexcept override { inner_.write(force); }
  DeviceStatus status() override { return inner_.status(); }

 private:
  SimulatedDevice inner_;
  int reads_ = 0;
};

}  // namespace

namespace {

constexpr std::size_t kParts = 8;  // without the plug

// A stylus that requires calibration, and whose hand unplugs it on request and plugs it in again.
class AskingDevice final : public Device {
 public:
  const DeviceInfo& info() const noexcept override { return inner_.info(); }
  DevicePose read(double dt_s) noexcept override {
    DevicePose pose = inner_.read(dt_s);
    pose.fault = !calibrated_;
    return pose;
  }
  void write(ForceN force) noexcept override { inner_.write(force); }
  DeviceStatus status() override {
    DeviceStatus status = inner_.status();
    if (!calibrated_) status.ready = false, status.asks_calibrate = true, status.text = "Hold it upright.";
    return status;
  }
  void calibrate() override { calibrated_ = true; }
  void plug(bool in) { inner_.plug(in); }

 private:
  SimulatedDevice inner_;
  std::atomic<bool> calibrated_{false};
};

}  // namespace

TEST_CASE(
    "the simulated stylus passes every part of the check, each asked for but the first: late, lost and doubled ticks, "
    "a loop and a window that "
    "stand, places that leap, are none or are old, scenes that are swapped") {
  int asked = 0;
  std::vector<CheckedPart> parts;
  // The loop runs on a real thread. If the machine delays it, the check correctly reports this, and the run is
  // repeated.
  for (int run = 0; run < 5; ++run) {
    asked = 0;
    parts = checkDevice(std::make_unique<SimulatedDevice>(), {.ask =
                                                                  [&](const std::string&) {
                                                                    ++asked;
                                                                    return true;
                                                                  },
                                                              .part_s = 0.6});
    REQUIRE(parts.size() == kParts);
    if (std::all_of(parts.begin(), parts.end(), [](const CheckedPart& p) { return p.passed; })) break;
  }
  for (const CheckedPart& part : parts) {
    CAPTURE(part.name);
    CHECK(part.done);
    CHECK_MESSAGE(part.passed, part.found);
  }
  CHECK(asked == int(kParts) - 1);
}

TEST_CASE("a part that the person does not want is left out and gives no force") {
  const auto parts = checkDevice(std::make_unique<SimulatedDevice>(),
                                 {.ask = [](const std::string&) { return false; }, .part_s = 0.1});
  REQUIRE(parts.size() == kParts);
  CHECK(parts.front().passed);
  CHECK_FALSE(parts.front().forces);
  for (std::size_t k = 1; k < kParts; ++k) {
    CHECK_FALSE(parts[k].done);
    CHECK(parts[k].forces);
    CHECK(parts[k].found == "not wanted");
  }
}

TEST_CASE("a device that is unplugged in the first part fails it, and the parts with force are left out") {
  const auto parts =
      checkDevice(std::make_unique<LoseableDevice>(), {.ask = [](const std::string&) { return true; }, .part_s = 0.4});
  CHECK_FALSE(parts.front().passed);
  CHECK(parts.front().found.find("unplugged") != std::string::npos);
  for (std::size_t k = 1; k < parts.size(); ++k) CHECK_FALSE(parts[k].done);
}

TEST_CASE(
    "a device that is not ready is prepared first: its instructions are shown, the user confirms, "
    "and it is calibrated; without confirmation the reason why nothing was checked is reported") {
  int shown = 0, asked = 0;
  const auto no = [&](const std::string&) { return ++asked, false; };
  const auto third = [&](const DeviceStatus& status) {
    CHECK(status.text == "Hold it upright.");
    return ++shown == 3;
  };
  auto parts = checkDevice(std::make_unique<AskingDevice>(), {.ask = no, .guide = third, .part_s = 0.1});
  CHECK(shown >= 3);
  CHECK(parts.front().done);
  CHECK(parts.front().passed);
  CHECK(asked == int(kParts) - 1);
  asked = 0;
  parts = checkDevice(std::make_unique<AskingDevice>(),
                      {.ask = no, .guide = [](const DeviceStatus&) { return false; }, .part_s = 0.1, .ready_s = 0.2});
  CHECK(asked == 0);
  for (const CheckedPart& part : parts) {
    CHECK_FALSE(part.done);
    CHECK(part.found == "the device is not ready. Hold it upright.");
  }
}

TEST_CASE("interrupted in a pull: no force in the next ticks, and all that is left is left out") {
  int asked = 0;
  const auto parts =
      checkDevice(std::make_unique<SimulatedDevice>(), {.ask = [&](const std::string&) { return ++asked, true; },
                                                        .interrupted = [&] { return asked > 0; },
                                                        .part_s = 5.0});
  CHECK(asked == 1);
  CHECK(parts.front().passed);
  for (std::size_t k = 1; k < parts.size(); ++k) CHECK_FALSE(parts[k].passed);
}

TEST_CASE(
    "the plug: pulled on request, no force while unplugged, a soft return when it is plugged in "
    "again; the part is skipped if it is not pulled") {
  auto device = std::make_unique<AskingDevice>();
  AskingDevice* const raw = device.get();
  raw->calibrate();
  const auto only = [](const char* part) {
    return [part](const std::string& question) { return question.find(part) != std::string::npos; };
  };
  const auto hand = [raw](const std::string& what) {
    if (what.find("Pull") == 0) raw->plug(false);
    if (what.find("Now plug") == 0) raw->plug(true);
  };
  auto parts = checkDevice(std::move(device), {.ask = only("plug"), .tell = hand, .part_s = 0.1, .unplug_s = 5.0});
  REQUIRE(parts.size() == kParts + 1);
  CHECK(parts.back().done);
  CHECK_MESSAGE(parts.back().passed, parts.back().found);
  CHECK(parts.back().found.find("no force while it was away, and softly back") == 0);
  parts = checkDevice(std::make_unique<SimulatedDevice>(), {.ask = only("plug"), .part_s = 0.1, .unplug_s = 0.2});
  CHECK_FALSE(parts.back().done);
  CHECK(parts.back().found == "it was not unplugged");
}

namespace {

// The loop without its safety stage: the tracker's force is passed to the device directly.
struct Careless final : ClockListener {
  explicit Careless(FaultyDevice& on) : device(on) {}
  void onDeviceTick() noexcept override {
    const DevicePose pose = device.read(kTick_s);
    const Vec3 wanted = pose.position.mm - at_mm;
    device.write({pose.connected ? Vec3(wanted * stiffness_N_per_mm) : Vec3(0.0)});
  }
  FaultyDevice& device;
  Vec3 at_mm{0.0};
  double stiffness_N_per_mm = 0.0;
};

// A device that is where it was put, whose clock the test is.
class PutDevice final : public Device {
 public:
  PutDevice() { info_.gives_force = true; }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override { return pose; }
  void write(ForceN) noexcept override {}
  bool startClock(ClockListener& target) override {
    clock = &target;
    return true;
  }
  DevicePose pose;
  ClockListener* clock = nullptr;

 private:
  DeviceInfo info_{phantomOmniFigures()};
};

}  // namespace

TEST_CASE(
    "the judge of the check finds what a loop without safety does: a leap, no number, an old place, a gone device and "
    "what follows a stand") {
  using Fault = LoopFault;
  struct Case {
    Fault fault;
    int ticks;
    double at_mm;
    const char* broken;
  };
  for (const Case& one :
       {Case{Fault::None, 0, 2.0, nullptr}, Case{Fault::PositionJump, 3, 2.0, "over the greatest force"},
        Case{Fault::NotANumber, 1, 2.0, "the force is not finite"},
        Case{Fault::Frozen, 60, 2.0, "force at a stale place"},
        Case{Fault::Stall, 1, 2.0, "more force than softly after a fault"}}) {
    CAPTURE(int(one.fault));
    auto put = std::make_unique<PutDevice>();
    PutDevice& raw = *put;
    FaultyDevice device(std::move(put));
    Careless loop(device);
    device.startClock(loop);
    raw.pose.position.mm = {one.at_mm, 0, 0};
    for (int k = 0; k < 600; ++k) {  // slowly to 1 N
      loop.stiffness_N_per_mm = std::min(0.5, 0.001 * k);
      raw.clock->onDeviceTick();
    }
    CHECK(device.given().broken == nullptr);
    device.inject(one.fault, one.ticks);
    for (int k = 0; k < 100; ++k) raw.clock->onDeviceTick();
    const char* const broken = device.given().broken;
    if (one.broken) {
      REQUIRE(broken);
      CHECK(std::string(broken) == one.broken);
    } else {
      CHECK(broken == nullptr);
    }
    device.stopClock();
  }
}
