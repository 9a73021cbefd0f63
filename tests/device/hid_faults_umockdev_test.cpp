// Faults of a HID device through the real libhidapi: unplugged during use, invalid or short reports, read errors. Runs
// under umockdev-wrapper. The effect is judged at the end of the whole loop.
#include <cmath>
#include <memory>
#include <utility>

#include "engine/bench/scenes.h"
#include "engine/device/mouse_device.h"
#include "engine/haptics/interactions.h"
#include "engine/servo/device_switch.h"
#include "engine/servo/plain_trackers.h"
#include "tests/device/hid_testbed.h"
#include "tests/device/mocked_hids.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// The servo loop over a device, the mouse as the fallback, and a pull wherever the hand is: far enough to be felt with
// the little stiffness that is left on a slow machine.
class Loop {
 public:
  explicit Loop(Device& device, Interaction* felt = nullptr)
      : device_(device), switch_(mouse_, &device), pull_(40.0), felt_(felt ? felt : &pull_) {
    settings_.workspace.A_per_mm = 1.0;
  }

  ServoSample tick() {
    const ServoSample sample = step_.tick(settings_, felt_, switch_.read(kTick_s, step_));
    switch_.write({sample.force});
    if (std::exchange(was_back_, switch_.fallenBack()) != switch_.fallenBack())
      last_ = Vec3(0.0);  // another one is given force
    const double most = switch_.fallenBack() ? 0.0 : device_.info().max_force_N, size = glm::length(sample.force.N);
    CHECK(finite(sample.force.N));
    CHECK(finite(sample.hip.A));
    if (!switch_.fallenBack()) CHECK(size <= most);
    CHECK(glm::distance(sample.force.N, last_) <= 1.0 + 1e-9);
    last_ = sample.force.N;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return sample;
  }
  bool fallenBack() const { return switch_.fallenBack(); }

 private:
  MouseDevice mouse_;
  Device& device_;
  DeviceSwitch switch_;
  ServoStep step_;
  ServoSettings settings_;
  ConstantForceTracker pull_;
  Interaction* felt_;
  Vec3 last_{0.0};
  bool was_back_ = false;
};

// The device sends its place, and the loop ticks, until the hand feels something.
ServoSample feel(HidTestbed& bed, Loop& loop) {
  ServoSample sample;
  for (int k = 0; k < 3000 && glm::length(sample.force.N) < 0.3; ++k) {
    bed.send(counts(k % 2, 0, 0));
    bed.written();
    sample = loop.tick();
  }
  return sample;
}

}  // namespace

TEST_CASE(
    "unplugged under the hand: the mouse leads, the list no longer has it, and plugged in again it leads from a soft "
    "start") {
  HidTestbed bed;
  bed.plug(kWoodenHaptics);
  const auto device = opened("woodenhaptics");
  holdUpright(bed, *device);
  Loop loop(*device);
  CHECK(glm::length(feel(bed, loop).force.N) >= 0.3);

  bed.unplug();
  ServoSample sample;
  waitFor([&] { return (sample = loop.tick(), loop.fallenBack()); });
  CHECK(loop.fallenBack());
  CHECK_FALSE(device->status().connected);
  CHECK(device->status().text == "WoodenHaptics is unplugged: plug it in again.");
  for (const FoundDevice& one : findDevices())
    if (one.name == "woodenhaptics") CHECK(one.why == "none is plugged in");

  bed.plug(kWoodenHaptics);
  waitFor([&] { return device->status().connected; });
  CHECK(device->status().connected);
  CHECK_FALSE(device->status().ready);  // it may have been switched off meanwhile
  holdUpright(bed, *device);
  bed.send(counts(0, 0, 0));
  waitFor([&] { return (sample = loop.tick(), !loop.fallenBack()); });
  CHECK_FALSE(loop.fallenBack());
  CHECK(glm::length(sample.force.N) < 0.05);
  CHECK(glm::length(feel(bed, loop).force.N) >= 0.3);
}

TEST_CASE(
    "ten times unplugged and plugged in, at any moment of the reports: it is reported each time, and "
    "works after the last; seed 3") {
  HidTestbed bed;
  bed.plug(kWoodenHaptics);
  const auto device = opened("woodenhaptics");
  holdUpright(bed, *device);
  Loop loop(*device);
  scenes::Random random(3);
  for (int time = 0; time < 10; ++time) {
    for (int k = 0; k < int(random.uniform(0, 20)); ++k) {
      bed.send(counts(k, 0, 0));
      loop.tick();
    }
    bed.unplug();
    waitFor([&] { return (loop.tick(), loop.fallenBack()); });
    CHECK(loop.fallenBack());
    bed.plug(kWoodenHaptics);
    waitFor([&] { return (loop.tick(), !loop.fallenBack()); });
    CHECK_FALSE(loop.fallenBack());
  }
  holdUpright(bed, *device);
  CHECK(glm::length(feel(bed, loop).force.N) >= 0.3);
}

TEST_CASE(
    "600 reports of random length and bytes, sound ones between: places and forces stay finite and limited, and the "
    "next sound "
    "report is read right; seed 4") {
  HidTestbed bed;
  bed.plug(kWoodenHaptics);
  const auto device = opened("woodenhaptics");
  holdUpright(bed, *device);
  Loop loop(*device);
  scenes::Random random(4);
  for (int k = 0; k < 600; ++k) {
    Bytes report(std::size_t(random.uniform(1, 65)));
    for (auto& byte : report) byte = std::uint8_t(random.uniform(0, 256));
    bed.send(k % 4 ? report : counts(k % 7, 0, 0));
    bed.written();
    CHECK_FALSE(loop.tick().force.N.x > 5.0);
  }
  CHECK(device->status().connected);
  DevicePose pose;
  waitFor([&] {
    return (bed.send(counts(0, -6000, 0)), std::abs((pose = device->read(0.001)).position.mm.z + 15.0) < 0.5);
  });
  CHECK(pose.position.mm.z == doctest::Approx(205 - 220));
}

TEST_CASE(
    "reports cut off after 3 and 6 bytes give no position; after 40 ms of them there is no force, "
    "and with complete ones it returns") {
  HidTestbed bed;
  bed.plug(kWoodenHaptics);
  const auto device = opened("woodenhaptics");
  holdUpright(bed, *device);
  Loop loop(*device);
  feel(bed, loop);
  const Vec3 before = device->read(0.001).position.mm;
  ServoSample sample;
  for (int k = 0; k < 100; ++k) {
    bed.send(Bytes(k % 2 ? 3 : 6, 0x11));  // joined they are no whole report either
    bed.written();
    sample = loop.tick();
  }
  CHECK(device->read(0.001).position.mm == before);
  CHECK(device->read(0.001).connected);
  CHECK(sample.force.N == Vec3(0));
  CHECK(sample.limits.has(Limit::StalePlace));
  CHECK(glm::length(feel(bed, loop).force.N) >= 0.3);
}

TEST_CASE(
    "a body of three spheres in the hand, pressed into another sphere: with 400 random reports between sound ones, and "
    "unplugged in contact, force and torque stay finite and limited, and plugged in again it begins softly; seed 26") {
  HidTestbed bed;
  bed.plug(kWoodenHaptics);
  const auto device = opened("woodenhaptics");
  holdUpright(bed, *device);
  // The hand begins 220 mm behind the middle and 40 mm below it, and moves back and forth through the last sphere.
  std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}, {{2, 0, 0}, 1.6}, {{0, 2, 0}, 1.6}, {{0, -140, -45}, 60.0}};
  const std::uint32_t held[] = {0, 1, 2};
  InteractionInput input;
  input.spheres = std::make_shared<const SphereGrid>(spheres, held);
  input.body = heldBody(spheres, held);
  input.touch = resolveInteraction({}, true);
  const std::unique_ptr<Interaction> body = makeInteraction(input);
  REQUIRE(body);
  REQUIRE(body->hasOrientation());
  Loop loop(*device, body.get());
  scenes::Random random(26);
  int felt = 0, garbled = 0;
  for (int k = 0; k < 1200; ++k) {
    // Motor counts of a hand that moves back and forth through the surface.
    const bool sound = k % 150 < 100;
    Bytes report(std::size_t(random.uniform(1, 65)));
    for (auto& byte : report) byte = std::uint8_t(random.uniform(0, 256));
    bed.send(sound ? counts(k % 5, -int(3000 - 3000 * std::cos(0.004 * k)), 0) : report);
    bed.written();
    const ServoSample sample = loop.tick();
    CHECK(finite(sample.torque_N_mm));
    garbled += !sound;
    felt += glm::length(sample.force.N) > 0.05;
  }
  CHECK(garbled == 400);
  CHECK(felt > 20);
  bed.unplug();
  waitFor([&] { return (loop.tick(), loop.fallenBack()); });
  CHECK(loop.fallenBack());
  bed.plug(kWoodenHaptics);
  waitFor([&] { return device->status().connected; });
  holdUpright(bed, *device);
  bed.send(counts(0, 0, 0));
  ServoSample sample;
  waitFor([&] { return (sample = loop.tick(), !loop.fallenBack()); });
  CHECK_FALSE(loop.fallenBack());
  CHECK(glm::length(sample.force.N) < 0.05);
}

TEST_CASE(
    "a SpaceMouse that is unplugged while its cap is pushed stands still, and moves on from there when it is back") {
  HidTestbed bed;
  bed.plug(kSpaceMouse);
  const auto device = opened("spacemouse");
  const Bytes push{1, 0x5E, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  waitFor([&] { return (bed.send(push), device->read(0.001).position.mm.x > 1.0); });
  CHECK(device->read(0.001).position.mm.x > 1.0);
  bed.unplug();
  waitFor([&] { return !device->read(0.001).connected; });
  const double stood = device->read(0.001).position.mm.x;
  CHECK_FALSE(device->read(0.001).connected);
  bed.plug(kSpaceMouse);
  waitFor([&] { return device->read(0.001).connected; });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK(device->read(0.001).position.mm.x == stood);  // the push is forgotten
  waitFor([&] { return (bed.send(push), device->read(0.001).position.mm.x > stood + 1.0); });
  CHECK(device->read(0.001).position.mm.x > stood + 1.0);
}
