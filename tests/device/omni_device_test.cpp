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
    OmniDevice::letGo();
    call<void(bool)>("standInReset")(manual);
  }
  ~StandIn() {
    OmniDevice::letGo();
    delete library;
  }
  template <class F>
  F* call(const char* name) const {
    return reinterpret_cast<F*>(library->symbol(name));
  }
  void step(int ticks) const { call<void(int)>("standInStep")(ticks); }
  void attach(bool on) const { call<void(bool)>("standInAttach")(on); }
  void error(std::uint32_t code) const { call<void(std::uint32_t)>("standInError")(code); }
  void calibration(std::uint32_t state, std::uint32_t style) const { call<void(std::uint32_t, std::uint32_t)>("standInCalibration")(state, style); }
  void buttons(int bits) const { call<void(int)>("standInButtons")(bits); }
  void dock(bool on) const { call<void(bool)>("standInDock")(on); }
  void updatesNeeded(int times) const { call<void(int)>("standInUpdatesNeeded")(times); }
  void init(int ms, std::uint32_t error) const { call<void(int, std::uint32_t)>("standInInit")(ms, error); }
  int inits() const { return call<int()>("standInInits")(); }
  void stopClock(bool stopped) const { call<void(bool)>("standInStopClock")(stopped); }
  int errorsLeft() const { return call<int()>("standInErrorsLeft")(); }
  bool initialised() const { return call<bool()>("standInInitialised")(); }
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

// Asks until it is there, at most some seconds; what it waits for is checked afterwards.
void untilThere(Device& device) {
  for (int k = 0; k < 1000 && !device.status().connected; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK(device.status().connected);
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

TEST_CASE("the device's figures are read from the driver: 3.3 N, 0.88 N, 0.5 N/mm, 3 N s/m, 160 x 120 x 70 mm, "
          "1.2 m/s, 4 N a tick; three degrees of freedom are used either way") {
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
  CHECK(info.speed_limit_m_per_s == doctest::Approx(1.2));
  CHECK(info.slew_limit_N_per_s == doctest::Approx(4000));
  CHECK(info.dof_in == 3);
  CHECK(info.dof_out == 3);
  CHECK_FALSE(OmniDevice::open());  // there is one default device
}

TEST_CASE("a place is told from the middle of the usable room, wherever the driver has its origin") {
  Vec3 hand[2];
  for (const bool aside : {false, true}) {
    const StandIn omni;
    if (aside) omni.call<void(double, double, double)>("standInRoom")(10.0, 20.0, -5.0);
    const auto device = opened();
    CHECK(device->info().workspace_mm == Vec3(160, 120, 70));
    Loop loop(*device);
    omni.step(100);
    hand[aside] = loop.last.hand.mm;
  }
  CHECK(glm::distance(hand[0] - hand[1], Vec3(10, 20, -5)) < 1e-9);
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
  CHECK(omni.errorsLeft() == 0);
  CHECK_FALSE(omni.initialised());
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
  // The switch is open while the stylus is docked; the words say that it is seen there.
  omni.dock(true);
  omni.step(1);
  CHECK(device->status().text == "Calibrating: leave the stylus in the inkwell.");
  CHECK_FALSE(device->status().asks_calibrate);
  omni.dock(false);
  omni.step(1);
  CHECK(device->status().text.find("Put the stylus's tip into the inkwell") == 0);
  omni.dock(true);
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
  CHECK(device->status().text.find("Hold the arm in its resting place") == 0);
  CHECK(device->status().asks_calibrate);
  device->calibrate();
  omni.step(20);
  CHECK(omni.updates() == 1);
  CHECK(device->status().ready);
}

TEST_CASE("encoder reset: where the driver asks for an update nothing runs by itself either; asked once, the update is repeated until it has been "
          "taken, 25 times here; where it is not taken in 3 s the words say so and ask again") {
  const StandIn omni;
  omni.calibration(hd::kNeedsUpdate, hd::kEncoderReset);
  omni.updatesNeeded(25);
  const auto device = opened();
  Loop loop(*device);
  omni.step(500);
  CHECK(omni.updates() == 0);
  CHECK(device->status().asks_calibrate);
  CHECK(device->status().text.find("is being calibrated") == std::string::npos);
  device->calibrate();
  omni.step(15);
  CHECK_FALSE(device->status().asks_calibrate);
  CHECK(device->status().text.find("is being calibrated") != std::string::npos);
  omni.step(400);
  CHECK(omni.updates() == 25);
  CHECK(device->status().ready);
  CHECK(omni.errorsLeft() == 0);

  omni.calibration(hd::kNeedsUpdate, hd::kEncoderReset);
  omni.updatesNeeded(100'000);
  omni.step(200);
  device->calibrate();
  omni.step(3100);
  CHECK(device->status().asks_calibrate);
  CHECK(device->status().text.find("The device did not take that place. Hold the arm") == 0);
}

TEST_CASE("what is asked of the driver is of the type that it has: no error of a wrong call in 10 s of any style of calibration") {
  for (const std::uint32_t style : {hd::kInkwell, hd::kAuto, hd::kEncoderReset}) {
    CAPTURE(style);
    const StandIn omni;
    omni.calibration(hd::kNeedsManualInput, style);
    const auto device = opened();
    CHECK(omni.errorsLeft() == 0);
    Loop loop(*device);
    omni.step(5000);
    omni.calibration(hd::kCalibrated, style);
    for (int k = 0; k < 5000; ++k) {
      omni.step(1);
      REQUIRE(omni.errorsLeft() == 0);
    }
    CHECK_MESSAGE(device->status().text.empty(), device->status().text);
  }
}

TEST_CASE("an error of a wrong call, in every frame and in any order, hides neither a cut force nor warm motors nor a calibration's words") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  const auto frames = [&](std::uint32_t code) {
    for (int k = 0; k < 6; ++k) {
      omni.error(hd::kInvalidInputType);
      if (k == 2) omni.error(code);
      omni.error(hd::kInvalidEnum);
      omni.step(1);
    }
  };
  frames(hd::kNoError);
  CHECK(device->status().text.find("error 0x010") != std::string::npos);
  for (const hd::Error code : {hd::kExceededVelocity, hd::kWarmMotors}) {
    CAPTURE(code);
    frames(code);
    CHECK(device->status().text.find(hd::errorWords(code).message) == 0);
    frames(hd::kNoError);  // later ones do not take its place while it is shown
    CHECK(device->status().text.find(hd::errorWords(code).message) == 0);
  }
  CHECK(loop.last.limits.has(Limit::DeviceFault));
  omni.calibration(hd::kNeedsManualInput, hd::kInkwell);
  omni.dock(true);
  frames(hd::kNoError);
  omni.step(100);
  CHECK(device->status().text == "Calibrating: leave the stylus in the inkwell.");
}

TEST_CASE("buttons come as bits") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  omni.buttons(3);
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
  CHECK(omni.errorsLeft() == 0);
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
  untilThere(*device);
  omni.step(2);
  CHECK_FALSE(loop.devices.fallenBack());
  CHECK(omni.force() < 0.1);
  press(omni, loop);
}

TEST_CASE("where the maker's clock stands the last place is stale and older by 1 ms a read, and after 100 ms of it the fallback leads") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  for (int k = 1; k <= 101; ++k) {
    loop.tickOfDevice();  // the loop's own clock
    CHECK(loop.devices.fallenBack() == (k > 100));
  }
  const DevicePose stale = device->read(kTick_s);
  CHECK_FALSE(stale.fresh);
  CHECK(stale.age_s == doctest::Approx(0.102));
  CHECK(device->status().connected);  // a short stop is not told
  omni.step(1);
  CHECK_FALSE(loop.devices.fallenBack());
}

TEST_CASE("a maker's clock that stands for half a second is told, and the device is opened anew until it ticks again") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  omni.stopClock(true);
  omni.step(1);
  for (int k = 0; k < 501; ++k) loop.tickOfDevice();
  CHECK(loop.devices.fallenBack());
  DeviceStatus status = device->status();
  CHECK_FALSE(status.connected);
  CHECK_FALSE(status.ready);
  CHECK(status.text.find("no longer answers") != std::string::npos);
  untilThere(*device);
  CHECK(omni.inits() == 2);
  omni.step(1);
  CHECK_FALSE(loop.devices.fallenBack());
  CHECK(device->status().ready);
  press(omni, loop);
}

TEST_CASE("no place is told before the first frame: until then the fallback leads") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  loop.tickOfDevice();
  CHECK(loop.devices.fallenBack());
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
  OmniDevice::letGo();
  omni.call<unsigned(const char*)>("hdInitDevice")(nullptr);
  CHECK(OmniDevice::open().problem().text().find("another program uses the device; end that program") != std::string::npos);
}

TEST_CASE("an error that stands in the way of something is told in one sentence, whatever it is") {
  for (std::uint32_t code = 0x0100; code <= 0x0600; ++code) {
    const std::string text = hd::problemOf("it could not be opened", hd::errorWords(code)).text();
    CAPTURE(text);
    REQUIRE(text.find(".;") == std::string::npos);
    REQUIRE_FALSE(text.ends_with('.'));
  }
  CHECK(hd::problemOf("it could not be opened", hd::errorWords(hd::kDeviceFault)).text() ==
        "it could not be opened: the device reports a fault; look at its power supply and its cable, then plug it in again");
  CHECK(hd::problemOf("it could not be opened", hd::errorWords(hd::kInvalidLicense)).message == "it could not be opened: OpenHaptics has no valid licence");
}

TEST_CASE("a device that is in use here is listed with its model and serial number all the same") {
  const StandIn omni;
  const auto device = opened();
  const FoundDevice one = findDevices().front();
  CHECK(one.usable);
  CHECK(one.title == "Stand-in Omni");
  CHECK(one.place == "serial number 42, in use here");
}

TEST_CASE("a start initialises the device once: what the looks have opened is what is opened then; what nobody takes is closed after 2 s") {
  const StandIn omni;
  const std::vector<FoundDevice> found = findDevices();
  CHECK(defaultDevice(found).name == "omni");
  CHECK(findDevice("omni")->usable);
  {
    const auto device = openDevice("omni");
    REQUIRE(device);
    CHECK(findDevice("omni")->place == "serial number 42, in use here");
  }
  CHECK(omni.inits() == 1);
  CHECK_FALSE(omni.initialised());
  findDevices();
  CHECK(omni.initialised());
  for (int k = 0; k < 200 && omni.initialised(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK_FALSE(omni.initialised());
}

TEST_CASE("a device that opens with warm motors is opened, and one that opens with a fault is closed again: neither is left behind") {
  const StandIn omni;
  omni.init(0, hd::kWarmMotors);
  { CHECK(OmniDevice::open()); }
  CHECK_FALSE(omni.initialised());
  omni.init(0, hd::kDeviceFault);
  CHECK(OmniDevice::open().problem().text().find("reports a fault") != std::string::npos);
  CHECK_FALSE(omni.initialised());
  omni.init(0, hd::kNoError);
  CHECK(OmniDevice::open());
}

TEST_CASE("while a lost device is opened anew, 300 ms here, the window is answered at once and the loop goes on with the mouse") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  omni.attach(false);
  omni.step(2);
  omni.init(300, hd::kNoError);
  omni.attach(true);
  CHECK_FALSE(device->status().connected);
  int answers = 0;
  for (; !device->status().connected && answers < 100'000; ++answers) {
    loop.tickOfDevice();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  CHECK(answers > 10);  // it was asked many times meanwhile
  CHECK(loop.devices.fallenBack());
  CHECK(omni.inits() == 2);
  omni.step(1);
  CHECK_FALSE(loop.devices.fallenBack());
}

TEST_CASE("the window asks, calibrates and reads figures while the clock ticks, stands, loses the device and finds it again: nobody trips over the other") {
  const StandIn omni(false);
  MouseDevice mouse;
  ServoThread servo(mouse);
  auto device = openDevice("omni");
  REQUIRE(device);
  Device* const stylus = device->get();
  servo.setDevice(std::move(*device));
  int lost = 0;
  const auto ask = [&](int ms) {
    for (int k = 0; k < ms; ++k) {
      lost += !stylus->status().connected;
      stylus->calibrate();
      CHECK(stylus->info().max_force_N == 3.3);
      servo.drain([](const ServoSample& sample) { CHECK(finite(sample.force.N)); });
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  ask(150);
  omni.calibration(hd::kNeedsUpdate, hd::kEncoderReset);
  omni.error(hd::kWarmMotors);
  omni.error(hd::kExceededVelocity);
  ask(150);
  omni.attach(false);
  ask(100);
  omni.attach(true);
  ask(2500);
  CHECK(lost > 50);
  CHECK(stylus->status().connected);
  lost = 0;
  omni.stopClock(true);
  ask(1500);
  CHECK(lost > 0);
  untilThere(*stylus);
  const auto until = servo.latest().tick + 50;
  while (servo.latest().tick < until) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK_FALSE(servo.fallenBack());
  servo.setDevice(nullptr);
  CHECK_FALSE(omni.initialised());
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
  CHECK_FALSE(OmniDevice::taken());
  CHECK(omni.call<double()>("standInForceAtStop")() == 0.0);
}
