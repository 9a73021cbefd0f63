// An Omni that appears, disappears and stalls, with the stand-in libHD.so: how it is found, opened, lost and reopened,
// and by which thread. (Ordered after omni_device_test.cpp, whose first test requires that the library is not loaded
// yet.)
#include <doctest/doctest.h>

#include "engine/device/driver.h"
#include "engine/device/pending_device_open.h"
#include "engine/servo/servo_thread.h"
#include "tests/device/omni/stand_in.h"
#include "tests/servo/newest_tick.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "unplugged in contact: no force in that tick, words about the cable; plugged in again it is opened again and leads "
    "again") {
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
  for (int k = 0; k < 5; ++k) loop.onDeviceTick();
  CHECK(loop.devices.fallenBack());
  omni.attach(true);
  untilThere(*device);
  omni.step(2);
  CHECK_FALSE(loop.devices.fallenBack());
  CHECK(omni.force() < 0.1);
  press(omni, loop);
}

TEST_CASE(
    "where the maker's clock stands the last place is stale and older by 1 ms a read, and after 100 ms of it the "
    "fallback leads") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  for (int k = 1; k <= 101; ++k) {
    loop.onDeviceTick();  // the loop's own clock
    CHECK(loop.devices.fallenBack() == (k > 100));
  }
  const DevicePose stale = device->read(kTick_s);
  CHECK_FALSE(stale.fresh);
  CHECK(stale.age_s == doctest::Approx(0.102));
  CHECK(device->status().connected);  // a short interruption is not reported
  omni.step(1);
  CHECK_FALSE(loop.devices.fallenBack());
}

TEST_CASE(
    "a vendor's clock that stalls for half a second is reported, and the device is reopened until it "
    "ticks again") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  omni.stopClock(true);
  omni.step(1);
  for (int k = 0; k < 501; ++k) loop.onDeviceTick();
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

TEST_CASE(
    "where the maker's clock stands for 20 ms in contact the output stays on, after 21 ms the guard switches it off; "
    "with "
    "the next ticks it is on again and the force begins below 0.1 N") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  press(omni, loop);
  CHECK(omni.driven() >= 0.7);
  StandIn::stand(20);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));  // the guard has looked some times
  CHECK(omni.driven() >= 0.7);
  StandIn::stand(1);
  const auto until = [&](bool on) {
    for (int k = 0; k < 10'000 && omni.forcesOn() != on; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return omni.forcesOn() == on;
  };
  REQUIRE(until(false));
  CHECK(omni.driven() == 0.0);
  omni.step(1);
  CHECK_FALSE(omni.forcesOn());
  CHECK(omni.force() == 0.0);
  omni.step(1);
  REQUIRE(until(true));
  omni.step(1);
  CHECK(omni.driven() < 0.1);
  press(omni, loop);
  CHECK_FALSE(loop.devices.fallenBack());
}

TEST_CASE("no position is reported before the first frame: until then the fallback device is used") {
  const StandIn omni;
  const auto device = opened();
  Loop loop(*device);
  loop.onDeviceTick();
  CHECK(loop.devices.fallenBack());
  omni.step(1);
  CHECK_FALSE(loop.devices.fallenBack());
}

TEST_CASE("no device, another program's device and no licence are distinguished") {
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
  OmniDevice::closeUnused();
  omni.call<unsigned(const char*)>("hdInitDevice")(nullptr);
  CHECK(OmniDevice::open().problem().text().find("another program uses the device; end that program") !=
        std::string::npos);
}

TEST_CASE("an error that prevents an operation is reported in one sentence, whatever it is") {
  for (std::uint32_t code = 0x0100; code <= 0x0600; ++code) {
    const std::string text = hd::problemOf("it could not be opened", hd::errorWords(code)).text();
    CAPTURE(text);
    REQUIRE(text.find(".;") == std::string::npos);
    REQUIRE_FALSE(text.ends_with('.'));
  }
  CHECK(hd::problemOf("it could not be opened", hd::errorWords(hd::kDeviceFault)).text() ==
        "it could not be opened: the device reports a fault; look at its power supply and its cable, then plug it in "
        "again");
  CHECK(hd::problemOf("it could not be opened", hd::errorWords(hd::kInvalidLicense)).message ==
        "it could not be opened: OpenHaptics has no valid licence");
}

TEST_CASE("a device that is in use here is listed with its model and serial number all the same") {
  const StandIn omni;
  const auto device = opened();
  const FoundDevice one = findDevices().front();
  CHECK(one.usable);
  CHECK(one.title == "Stand-in Omni");
  CHECK(one.place == "serial number 42, in use here");
}

TEST_CASE(
    "a start initialises the device once: the handle opened by the search is reused, and one that is "
    "not used is closed after 2 s") {
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

TEST_CASE(
    "a device that is unplugged while it is looked at again and again is missed in the end: no look keeps it for "
    "longer") {
  const StandIn omni;
  CHECK(findDevice("omni")->usable);
  omni.attach(false);
  for (int k = 0; k < 200 && findDevice("omni")->usable; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK_FALSE(findDevice("omni")->usable);
}

TEST_CASE(
    "a device that opens with warm motors is opened, and one that opens with a fault is closed again: neither is left "
    "behind") {
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

TEST_CASE(
    "while a lost device is opened again, 300 ms here, the window is answered at once and the loop continues with the "
    "mouse") {
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
    loop.onDeviceTick();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  CHECK(answers > 10);  // it was asked many times meanwhile
  CHECK(loop.devices.fallenBack());
  CHECK(omni.inits() == 2);
  omni.step(1);
  CHECK_FALSE(loop.devices.fallenBack());
}

TEST_CASE(
    "the window queries, calibrates and reads figures while the clock ticks, stalls, loses the "
    "device and finds it again, without interference") {
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
      servo.loop().drain([](const ServoSample& sample) { CHECK(finite(sample.force.N)); });
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
  test::NewestTick(servo.loop()).wait(50);
  CHECK_FALSE(servo.loop().fallenBack());
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
  test::NewestTick newest(servo.loop());
  newest.wait(200);
  CHECK_FALSE(servo.loop().fallenBack());
  CHECK(newest().hand.mm != Vec3(0));
  servo.setDevice(nullptr);
  CHECK_FALSE(OmniDevice::taken());
  CHECK(omni.call<double()>("standInForceAtStop")() == 0.0);
}

TEST_CASE("an Omni that this process has open is not opened again under its name: the driver is asked once") {
  const StandIn omni;
  PendingDeviceOpen first("omni", "");
  PendingDeviceOpen::Opened one = first.take();
  REQUIRE(one.device);
  CHECK_FALSE(one.in_use);
  CHECK(one.hardware == "omni serial number 42");
  PendingDeviceOpen second("omni", one.hardware);
  const PendingDeviceOpen::Opened again = second.take();
  CHECK(again.in_use);
  CHECK(omni.inits() == 1);
}
