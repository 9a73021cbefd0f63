// The Omni's driver against the stand-in libHD.so: the loop is closed through the C interface, its clock stepped by hand so
// that nothing depends on the machine. What this proves: the use of the interface, its errors and states; not a real device.
#include "engine/device/omni/omni_device.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "engine/device/driver.h"
#include "engine/device/mouse_device.h"
#include "engine/haptics/methods.h"
#include "engine/platform/shared_library.h"
#include "engine/servo/device_switch.h"
#include "engine/servo/servo_thread.h"

using namespace moltact;

namespace {

// The stand-in, as the driver will load it, and the test's own functions in it.
struct StandIn {
  explicit StandIn(bool manual = true) {
    setenv("MOLTACT_LIBHD", MOLTACT_STAND_IN_LIBHD, 1);
    const std::string name = MOLTACT_STAND_IN_LIBHD;
    const auto opened = SharedLibrary::open({&name, 1});
    REQUIRE(opened);
    library = new SharedLibrary(*opened);
    call<void(bool)>("standInReset")(manual);
  }
  ~StandIn() { delete library; }
  template <class F>
  F* call(const char* name) const {
    return reinterpret_cast<F*>(library->symbol(name));
  }
  void step(int ticks) const { call<void(int)>("standInStep")(ticks); }
  void attach(bool on) const { call<void(bool)>("standInAttach")(on); }
  void error(std::uint32_t code) const { call<void(std::uint32_t)>("standInError")(code); }
  void calibration(std::uint32_t state, std::uint32_t style) const { call<void(std::uint32_t, std::uint32_t)>("standInCalibration")(state, style); }
  double force() const { return call<double()>("standInForce")(); }
  std::uint32_t updates() const { return call<std::uint32_t()>("standInUpdates")(); }
  SharedLibrary* library = nullptr;
};

// What the haptic thread does with a device that brings its clock, without the thread.
struct Loop final : TickTarget {
  explicit Loop(Device& device) : stylus(device), devices(mouse, &device) {
    std::vector<Ball> balls;
    for (int k = 0; k < 27; ++k) balls.push_back({Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1) * 1.7, 1.6});
    tracker = methods().front().make(std::make_shared<const BallScene>(std::move(balls)), kWaterProbe_A);
    CHECK(stylus.startClock(*this));
  }
  ~Loop() { stylus.stopClock(); }
  void tickOfDevice() noexcept override {
    const DevicePose pose = devices.read(kTick_s, step);
    last = step.tick(settings, tracker.get(), pose);
    devices.write(last.force);
    ++ticks;
    greatest_N = std::max(greatest_N, glm::length(last.force.N));
  }
  Device& stylus;
  MouseDevice mouse;
  DeviceSwitch devices;
  ServoStep step;
  ServoSettings settings;
  std::unique_ptr<Tracker> tracker;
  ServoSample last;
  long ticks = 0;
  double greatest_N = 0;
};

std::unique_ptr<OmniDevice> opened() {
  auto device = OmniDevice::open();
  REQUIRE(device);
  return std::move(*device);
}

// Steps until the hand presses with some force.
void press(const StandIn& omni, Loop& loop) {
  for (int k = 0; k < 20'000 && glm::length(loop.last.force.N) < 0.7; ++k) omni.step(1);
  REQUIRE(glm::length(loop.last.force.N) >= 0.7);
}

}  // namespace

TEST_CASE("without libHD.so the list says in one line how to get it, and opening fails in the same words") {
  setenv("MOLTACT_LIBHD", "/nowhere/libHD.so", 1);
  // Once loaded the library stays; so this runs first.
  const auto device = openDevice("omni");
  REQUIRE_FALSE(device);
  CHECK(device.problem().remedy.find("libHD.so could not be loaded") != std::string::npos);
  CHECK(device.problem().remedy.find("OpenHaptics for Linux") != std::string::npos);
  CHECK(device.problem().text().find('\n') == std::string::npos);
}

TEST_CASE("the device's figures are read from the driver: 3.3 N, 0.88 N, 0.5 N/mm, 3 N s/m, 160 x 120 x 70 mm, 6 and 3 degrees of freedom") {
  const StandIn omni;
  const auto device = opened();
  const DeviceInfo& info = device->info();
  CHECK(info.name == "Stand-in Omni");
  CHECK(device->serial() == "42");
  CHECK(info.gives_force);
  CHECK(info.max_force_N == 3.3);
  CHECK(info.continuous_force_N == 0.88);
  CHECK(info.max_stiffness_N_per_mm == 0.5);
  CHECK(info.max_damping_N_s_per_m == doctest::Approx(3.0));
  CHECK(info.workspace_mm == Vec3(160, 120, 70));
  CHECK(info.dof_in == 6);
  CHECK(info.dof_out == 3);
  CHECK_FALSE(OmniDevice::open());  // there is one default device
}

TEST_CASE("30 s in the loop through the C interface: touched and pressed with about 1 N, no error left, and no force at the end") {
  const StandIn omni;
  {
    const auto device = opened();
    Loop loop(*device);
    int pressed = 0;
    for (int k = 0; k < 30'000; ++k) {
      omni.step(1);
      pressed += glm::length(loop.last.force.N) > 0.7;
    }
    CHECK(loop.ticks == 30'000);
    CHECK(pressed > 5000);
    CHECK(loop.greatest_N < 2.5);
    CHECK_FALSE(loop.devices.fallenBack());
    CHECK(device->status().text.empty());
    CHECK(device->status().motor_heat == doctest::Approx(0.1));
    press(omni, loop);
    CHECK(omni.force() >= 0.7);
    // The clock ends with a frame that gives no force.
    std::thread clock([&] { for (int k = 0; k < 200; ++k) omni.step(1), std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
    device->stopClock();
    clock.join();
  }
  CHECK(omni.call<double()>("standInForceAtStop")() == 0.0);
  CHECK(omni.call<int()>("standInErrorsLeft")() == 0);
  CHECK_FALSE(omni.call<bool()>("standInInitialised")());
}

TEST_CASE("inkwell: without calibration no force and the words say where the stylus goes; docked, it is calibrated and force comes softly") {
  const StandIn omni;
  omni.calibration(hd::kNeedsManualInput, hd::kInkwell);
  const auto device = opened();
  Loop loop(*device);
  for (int k = 0; k < 8000; ++k) {
    omni.step(1);
    REQUIRE(omni.force() == 0.0);
  }
  CHECK_FALSE(device->status().ready);
  CHECK(device->status().text.find("inkwell") != std::string::npos);
  CHECK(loop.last.limits.has(Limit::DeviceFault));
  omni.call<void(int, int)>("standInButtons")(0, 1);
  omni.calibration(hd::kNeedsUpdate, hd::kInkwell);
  omni.step(200);
  CHECK(omni.updates() == 1);
  CHECK(device->status().ready);
  press(omni, loop);
}

TEST_CASE("encoder reset: nothing happens until the person says that the arm is at rest") {
  const StandIn omni;
  omni.calibration(hd::kNeedsManualInput, hd::kEncoderReset);
  const auto device = opened();
  Loop loop(*device);
  omni.step(500);
  CHECK(omni.updates() == 0);
  CHECK(device->status().text.find("Calibrate") != std::string::npos);
  device->calibrate();
  omni.step(2);
  CHECK(omni.updates() == 1);
  CHECK(device->status().ready);
}

TEST_CASE("buttons come as bits") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  omni.call<void(int, int)>("standInButtons")(3, 0);
  omni.step(1);
  CHECK(loop.last.buttons == 3);
}

TEST_CASE("warm motors: the force falls to the continuous 0.88 N, by the driver's error and by its temperature") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  omni.error(hd::kWarmMotors);
  omni.step(2);
  CHECK(device->status().text.find("motors are warm") != std::string::npos);
  double greatest = 0;
  for (int k = 0; k < 4000; ++k) omni.step(1), greatest = std::max(greatest, omni.force());
  CHECK(greatest < 0.88 + 1e-9);
  omni.step(2000);
  omni.call<void(double)>("standInHeat")(1.0);
  omni.step(200);
  CHECK(device->status().motor_heat == 1.0);
  greatest = 0;
  for (int k = 0; k < 6000; ++k) omni.step(1), greatest = std::max(greatest, omni.force());
  CHECK(greatest < 0.88 + 1e-9);
  CHECK(greatest > 0.8);
}

TEST_CASE("each error of the driver's stack is told in words, and a force it cut comes back softly") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  for (const hd::Error code : {hd::kExceededMaxForce, hd::kExceededImpulse, hd::kExceededVelocity, hd::kForceError}) {
    CAPTURE(code);
    omni.error(code);
    omni.step(6);
    CHECK(omni.force() == 0.0);
    CHECK(device->status().text.find(hd::errorWords(code).message) == 0);
  }
  omni.step(500);
  CHECK(omni.force() < 0.1);
  press(omni, loop);
  // A whole stack of them is drained in one frame.
  for (int k = 0; k < 30; ++k) omni.error(hd::kInvalidOperation);
  omni.step(1);
  CHECK(omni.call<int()>("standInErrorsLeft")() == 0);
}

TEST_CASE("unplugged in contact: no force in that tick, words about the cable; plugged in again it is opened anew and leads again") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  omni.attach(false);
  omni.step(2);
  CHECK(omni.force() == 0.0);
  CHECK_FALSE(device->status().connected);
  CHECK(device->status().text.find("cable") != std::string::npos);
  // The loop's own clock takes over and finds the fallback in its place.
  for (int k = 0; k < 5; ++k) loop.tickOfDevice();
  CHECK(loop.devices.fallenBack());
  omni.attach(true);
  for (int k = 0; k < 100 && !device->status().connected; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK(device->status().connected);
  omni.step(2);
  CHECK_FALSE(loop.devices.fallenBack());
  CHECK(omni.force() < 0.1);
  press(omni, loop);
}

TEST_CASE("where the maker's clock stands the last place is stale, and after 100 ms of it the fallback leads") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  for (int k = 1; k <= 101; ++k) {
    loop.tickOfDevice();  // the loop's own clock
    CHECK(loop.devices.fallenBack() == (k > 100));
  }
  omni.step(1);
  CHECK_FALSE(loop.devices.fallenBack());
}

TEST_CASE("no device, another program's device and no licence are told apart") {
  const StandIn omni;
  omni.attach(false);
  CHECK(OmniDevice::open().problem().text().find("cable") != std::string::npos);
  const auto found = findDevices();
  CHECK(found.front().name == "omni");
  CHECK_FALSE(found.front().usable);
  omni.attach(true);
  CHECK(findDevices().front().title == "Stand-in Omni");
  CHECK(findDevices().front().place == "serial number 42");
  CHECK(defaultDevice(findDevices()).name == "omni");
  omni.call<unsigned(const char*)>("hdInitDevice")(nullptr);
  CHECK(OmniDevice::open().problem().text().find("Another program") != std::string::npos);
}

TEST_CASE("in the haptic thread, by the stand-in's own clock of 1 kHz, it leads until it is put away") {
  const StandIn omni(false);
  MouseDevice mouse;
  ServoThread servo(mouse);
  auto device = openDevice("omni");
  REQUIRE(device);
  servo.setDevice(std::move(*device));
  const auto until = servo.latest().tick + 200;
  while (servo.latest().tick < until) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK_FALSE(servo.fallenBack());
  CHECK(servo.latest().hand.mm != Vec3(0));
  servo.setDevice(nullptr);
  CHECK_FALSE(OmniDevice::inUse());
  CHECK(omni.call<double()>("standInForceAtStop")() == 0.0);
}
