// The real libhidapi with devices mocked by umockdev: enumeration, opening, reports in and out. Runs under
// umockdev-wrapper. Tests the use of the library and the parsing, neither USB timing nor a real device.
#include <algorithm>

#include "engine/device/driver.h"
#include "engine/device/hid/hid_kind.h"
#include "engine/device/packet/report_bytes.h"
#include "tests/device/hid_testbed.h"
#include "tests/device/mocked_hids.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE("without a HID device the list says that none is plugged in") {
  const HidTestbed bed;
  CHECK(listHid().empty());
  for (const FoundDevice& one : findDevices())
    if (one.name == "spacemouse") CHECK(one.why == "none is plugged in");
}

TEST_CASE(
    "a SpaceMouse is found by its ids and usage, opened, and its push moves the hand; the mouse stays the default") {
  HidTestbed bed;
  bed.plug(kSpaceMouse);
  const std::vector<FoundDevice> found = findDevices();
  const auto one =
      std::find_if(found.begin(), found.end(), [](const FoundDevice& d) { return d.name == "spacemouse"; });
  REQUIRE(one != found.end());
  CHECK_MESSAGE(one->usable, one->why);
  CHECK(one->title.find("SpaceMouse Compact") != std::string::npos);
  CHECK(one->place == "/dev/hidraw0");
  CHECK(defaultDevice(found).name == "mouse");

  const auto device = opened("spacemouse");
  DevicePose pose;
  waitFor([&] {
    bed.send({1, 0x40, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});  // right, 320 of 350
    bed.send({3, 2, 0});
    return (pose = device->read(0.001)).buttons == 2 && pose.position.mm.x > 1.0;
  });
  CHECK(pose.buttons == 2);
  CHECK(pose.position.mm.x > 1.0);
  CHECK(pose.position.mm.y == 0.0);
}

TEST_CASE("WoodenHaptics is found by its ids, read, and its currents are written") {
  HidTestbed bed;
  bed.plug(kWoodenHaptics);
  const auto device = opened("woodenhaptics");
  CHECK(device->info().gives_force);
  holdUpright(bed, *device);
  DevicePose pose;
  Bytes last;
  waitFor([&] {
    bed.send(counts(16, 16, 16));
    pose = device->read(0.001);
    device->write({Vec3(0, 0.5, 0)});
    const Bytes all = bed.written();
    // Whole reports of 8 bytes: hidapi takes the id 0 off.
    if (all.size() >= 8) last.assign(all.end() - 8, all.end());
    return pose.position.mm.y < -39 && last.size() == 8 && int16At(last, 2) != 0;
  });
  CHECK(pose.connected);
  CHECK(pose.position.mm.y < -39);
  REQUIRE(last.size() == 8);
  CHECK(int16At(last, 2) != 0);
}

TEST_CASE(
    "a device of the open layout is opened by its feature report; one that does not describe itself is refused in "
    "words") {
  OpenFirmware firmware;
  {
    HidTestbed bed;
    bed.plug(openLayout(firmware));
    const auto device = opened("open");
    CHECK(device->info().max_force_N == 4.0);
    CHECK(device->info().workspace_mm == Vec3(180, 140, 100));
    const auto place = firmware.tick({12, -7, 3});
    waitFor([&] { return (bed.send({place.begin(), place.end()}), device->read(0.001).position.mm.x > 11); });
    CHECK(glm::distance(device->read(0.001).position.mm, Vec3(12, -7, 3)) < 1e-9);
    Bytes got;
    waitFor([&] {
      device->write({Vec3(0.25, 0, 0)});
      const Bytes all = bed.written();
      if (all.size() >= 11) got.assign(all.end() - 11, all.end());
      return got.size() == 11 && got[0] == 2 && int16At(got, 3) == 250;
    });
    REQUIRE(got.size() == 11);
    firmware.take(got);
    CHECK(firmware.force_N().x == 0.25);
  }
  for (const Bytes& feature : {Bytes{}, Bytes{3, 'M', 'L'}, Bytes(32, 0xFF)}) {
    HidTestbed bed;
    MockedHid mute = openLayout(firmware);
    mute.feature = feature;
    bed.plug(mute);
    const auto refused = openDevice("open");
    REQUIRE_FALSE(refused);
    CHECK(refused.problem().remedy.find("Workshop Stylus: ") != std::string::npos);
    CHECK(refused.problem().remedy.find("its feature report 3 does not begin with 'MLTC'") != std::string::npos);
  }
}

TEST_CASE(
    "a receiver of another vendor with the same usage is listed by no driver and never the default; "
    "a device of the open layout beside it is") {
  const MockedHid receiver{"046D", "C52B", "Logitech USB Receiver", hidDescriptor(0xFF00, 1)};
  HidTestbed bed;
  bed.plug(receiver);
  CHECK(defaultDevice(findDevices()).name == "mouse");
  const auto one = findDevice("open");
  REQUIRE(one);
  CHECK_FALSE(one->usable);
  CHECK(one->why.find("none is plugged in; ") == 0);
  CHECK(one->why.find("Receiver") != std::string::npos);
  CHECK_FALSE(findDevice("open:2"));
}

TEST_CASE(
    "a DualShock 4 is found by its ids and usage, its stick moves the hand, and the force is written to its motors "
    "until the loop is silent") {
  HidTestbed bed;
  bed.plug(kDualShock);
  const auto device = opened("gamepad");
  CHECK_FALSE(device->info().gives_force);
  Bytes right(64);
  right[0] = 1, right[1] = 255, right[2] = right[3] = right[4] = 128;
  Bytes motors;
  const auto motorsSay = [&](std::uint8_t weak) {
    const Bytes all = bed.written();
    if (all.size() >= 32) motors.assign(all.end() - 32, all.end());
    return motors.size() == 32 && motors[0] == 5 && motors[4] == weak;
  };
  waitFor([&] {
    bed.send(right);
    device->write({Vec3(0, 0, 3.3)});
    return device->read(0.001).position.mm.x > 1.0 && motorsSay(255);
  });
  CHECK(device->read(0.001).position.mm.x > 1.0);
  CHECK(motorsSay(255));
  waitFor([&] { return motorsSay(0); });
  CHECK(motorsSay(0));
}

TEST_CASE("a DualSense is found by its ids and usage, and rumbles by a report of its own") {
  HidTestbed bed;
  bed.plug(kDualSensePad);
  const auto device = opened("dualsense");
  Bytes right(64);
  right[0] = 1, right[1] = 255, right[2] = right[3] = right[4] = 128;
  bool rumbled = false;
  const auto rumbles = [&] {
    const Bytes all = bed.written();
    rumbled = rumbled || (all.size() >= 48 && all[all.size() - 48] == 2 && all[all.size() - 45] == 255);
    return rumbled;
  };
  waitFor([&] {
    bed.send(right);
    device->write({Vec3(0, 0, 3.3)});
    return device->read(0.001).position.mm.x > 1.0 && rumbles();
  });
  CHECK(device->read(0.001).position.mm.x > 1.0);
  CHECK(rumbled);
}

TEST_CASE("a device of another vendor is not listed") {
  HidTestbed bed;
  bed.plug({"046D", "C077", "Logitech Mouse", hidDescriptor(1, 2)});
  for (const FoundDevice& one : findDevices())
    if (one.name != "simulated" && one.name != "mouse") CHECK_FALSE(one.usable);
}
