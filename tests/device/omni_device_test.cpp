// The Omni's driver with the stand-in libHD.so: a closed loop through the C interface, on the test's clock, so that the
// machine's speed does not matter. Tests the use of the interface, its errors and states, not a real device.
#include <doctest/doctest.h>

#include "engine/device/driver.h"
#include "tests/device/omni/stand_in.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE("without libHD.so the list says in one line how to get it, and opening fails in the same words") {
  setenv("MOLTACT_LIBHD", "/nowhere/libHD.so", 1);
  // Once loaded the library stays; so this runs first.
  const auto device = openDevice("omni");
  REQUIRE_FALSE(device);
  CHECK(device.problem().remedy.find("libHD.so could not be loaded") != std::string::npos);
  CHECK(device.problem().remedy.find("OpenHaptics for Linux") != std::string::npos);
  CHECK(device.problem().text().find('\n') == std::string::npos);
}

TEST_CASE(
    "the device's figures are read from the driver: 3.3 N, 0.88 N, 0.5 N/mm, 3 N s/m, 160 x 120 x 70 mm, "
    "1.2 m/s, 4 N a tick; six degrees of freedom are read and three driven") {
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
  // Values that the driver does not provide are from the literature.
  CHECK(info.friction_N == 0.26);
  CHECK(info.damping_N_s_per_m == 0.2);
  CHECK(info.resolution_mm == 0.055);
  CHECK(info.delay_s == 0.001);
  CHECK(info.speed_limit_m_per_s == doctest::Approx(1.2));
  CHECK(info.slew_limit_N_per_s == doctest::Approx(4000));
  CHECK(info.dof_in == 6);
  CHECK(info.dof_out == 3);
  CHECK_FALSE(OmniDevice::open());  // there is one default device
}

TEST_CASE("the stylus's orientation is read: a quarter turn about y, and the previous one if the driver gives none") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  omni.step(10);
  CHECK(glm::distance(loop.last.orientation * Vec3(1, 0, 0), Vec3(0, 0, -1)) < 1e-12);
  CHECK(loop.last.torque_N_mm == Vec3(0));
  double columns[16] = {};
  const Quat before = glm::angleAxis(0.3, Vec3(1, 0, 0));
  CHECK(hd::orientationOf(columns, before) == before);
  columns[0] = columns[5] = columns[10] = 2.0;
  CHECK(hd::orientationOf(columns, before) == before);
  columns[0] = columns[5] = columns[10] = 1.0;
  CHECK(hd::orientationOf(columns, before) == kNoRotation);
  columns[0] = std::nan("");
  CHECK(hd::orientationOf(columns, before) == before);
}

TEST_CASE("positions are relative to the centre of the usable workspace, wherever the driver has its origin") {
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

TEST_CASE(
    "30 s in the loop through the C interface: touched and pressed with about 1 N, no error left, and no force at the "
    "end") {
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
    CHECK(loop.peak_N < 2.5);
    CHECK_FALSE(loop.devices.fallenBack());
    CHECK(device->status().text.empty());
    CHECK(device->status().motor_heat == doctest::Approx(0.1));
    press(omni, loop);
    CHECK(omni.force() >= 0.7);
    // The clock ends with a frame that gives no force.
    std::atomic<bool> stopped{false};
    std::thread clock([&] {
      while (!stopped) omni.step(1), std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    device->stopClock();
    stopped = true;
    clock.join();
  }
  CHECK(omni.call<double()>("standInForceAtStop")() == 0.0);
  CHECK(omni.errorsLeft() == 0);
  CHECK_FALSE(omni.initialised());
}

TEST_CASE(
    "inkwell: without calibration no force and the words say where the stylus goes; docked, it is calibrated and force "
    "comes softly") {
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

TEST_CASE(
    "encoder reset: where the driver asks for an update nothing runs by itself either; asked once, the update is "
    "repeated until it has been "
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

TEST_CASE(
    "what is asked of the driver is of the type that it has: no error of a wrong call in 10 s of any style of "
    "calibration") {
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

TEST_CASE(
    "an error of a wrong call, in every frame and in any order, hides neither a cut force nor warm motors nor a "
    "calibration's words") {
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

TEST_CASE("each error of the driver's stack is reported in words, and a force it cut comes back softly") {
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
