// The stand-in libHD.so for tests of the Omni's driver, and a servo loop whose clock the test advances. A tick is one
// millisecond, also for the guard, at any speed of the machine.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/device/mouse_device.h"
#include "engine/device/omni/omni_device.h"
#include "engine/haptics/methods.h"
#include "engine/platform/shared_library.h"
#include "engine/servo/device_switch.h"

namespace moltact::test {

// The stand-in as the driver will load it, and its functions for tests.
struct StandIn {
  explicit StandIn(bool manual = true) {
    setenv("MOLTACT_LIBHD", MOLTACT_STAND_IN_LIBHD, 1);
    const std::string name = MOLTACT_STAND_IN_LIBHD;
    const auto opened = SharedLibrary::open({&name, 1});
    REQUIRE(opened);
    library = new SharedLibrary(*opened);
    OmniDevice::closeUnused();
    call<void(bool)>("standInReset")(manual);
  }
  ~StandIn() {
    OmniDevice::closeUnused();
    delete library;
  }
  template <class F>
  F* call(const char* name) const {
    return reinterpret_cast<F*>(library->symbol(name));
  }
  /// Time since the program's start, by ticks.
  static inline std::atomic<std::int64_t> stepped_ns{0};
  static std::int64_t now_ns() noexcept { return stepped_ns; }
  /// Advances the time without a tick.
  static void stand(int ms) { stepped_ns += std::int64_t(ms) * 1'000'000; }
  void step(int ticks) const {
    const auto step_stand_in = call<void(int)>("standInStep");
    for (int k = 0; k < ticks; ++k) stand(1), step_stand_in(1);
  }
  void attach(bool on) const { call<void(bool)>("standInAttach")(on); }
  void error(std::uint32_t code) const { call<void(std::uint32_t)>("standInError")(code); }
  void calibration(std::uint32_t state, std::uint32_t style) const {
    call<void(std::uint32_t, std::uint32_t)>("standInCalibration")(state, style);
  }
  void buttons(int bits) const { call<void(int)>("standInButtons")(bits); }
  void dock(bool on) const { call<void(bool)>("standInDock")(on); }
  void updatesNeeded(int times) const { call<void(int)>("standInUpdatesNeeded")(times); }
  void init(int ms, std::uint32_t error) const { call<void(int, std::uint32_t)>("standInInit")(ms, error); }
  int inits() const { return call<int()>("standInInits")(); }
  void stopClock(bool stopped) const { call<void(bool)>("standInStopClock")(stopped); }
  int errorsLeft() const { return call<int()>("standInErrorsLeft")(); }
  bool initialised() const { return call<bool()>("standInInitialised")(); }
  double force() const { return call<double()>("standInForce")(); }
  bool forcesOn() const { return call<bool()>("standInForcesOn")(); }
  double driven() const { return call<double()>("standInDriven")(); }
  void errorAtEnd(std::uint32_t code) const { call<void(std::uint32_t)>("standInErrorAtEnd")(code); }
  void failBegins(int frames, std::uint32_t code) const {
    call<void(int, std::uint32_t)>("standInFailBegins")(frames, code);
  }
  std::uint32_t updates() const { return call<std::uint32_t()>("standInUpdates")(); }
  SharedLibrary* library = nullptr;
};

// Does what the haptic thread does with a device that supplies its clock, without the thread.
struct Loop final : ClockListener {
  explicit Loop(Device& device) : stylus(device), devices(mouse, &device) {
    std::vector<Sphere> spheres;
    for (int k = 0; k < 27; ++k) spheres.push_back({Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1) * 1.7, 1.6});
    tracker = methods().front().make(std::make_shared<const SphereGrid>(std::move(spheres)), kWaterProbe_A);
    CHECK(stylus.startClock(*this));
  }
  ~Loop() { stylus.stopClock(); }
  void onDeviceTick() noexcept override {
    const DevicePose pose = devices.read(kTick_s, step);
    last = step.tick(settings, tracker.get(), pose);
    devices.write({last.force});
    ++ticks;
    peak_N = std::max(peak_N, glm::length(last.force.N));
  }
  Device& stylus;
  MouseDevice mouse;
  DeviceSwitch devices;
  ServoStep step;
  ServoSettings settings;
  std::unique_ptr<Tracker> tracker;
  ServoSample last;
  long ticks = 0;
  double peak_N = 0;
};

inline std::unique_ptr<OmniDevice> opened() {
  auto device = OmniDevice::open(&StandIn::now_ns);
  REQUIRE(device);
  return std::move(*device);
}

// Runs ticks until the hand presses with some force.
inline void press(const StandIn& omni, Loop& loop) {
  for (int k = 0; k < 20'000 && glm::length(loop.last.force.N) < 0.7; ++k) omni.step(1);
  REQUIRE(glm::length(loop.last.force.N) >= 0.7);
}

// Polls for a few seconds until the device is there; the caller checks the result.
inline void untilThere(Device& device) {
  for (int k = 0; k < 1000 && !device.status().connected; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK(device.status().connected);
}

}  // namespace moltact::test
