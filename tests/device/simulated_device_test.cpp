// The simulated stylus in the servo loop on a virtual clock: the scripted hand finds the molecule and presses. When it
// is unplugged, the fallback device takes over in the same tick.
#include "engine/device/simulated_device.h"

#include <doctest/doctest.h>

#include "engine/device/mouse_device.h"
#include "engine/haptics/methods.h"
#include "engine/servo/device_switch.h"

using namespace moltact;

namespace {

struct Rig {
  MouseDevice mouse;
  SimulatedDevice stylus;
  DeviceSwitch devices{mouse, &stylus};
  ServoStep step{mouse.info()};
  std::unique_ptr<Tracker> tracker;
  ServoSettings settings;

  Rig() {
    std::vector<Sphere> spheres;
    for (int k = 0; k < 27; ++k) spheres.push_back({Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1) * 1.7, 1.6});
    settings.workspace.centre_A = {
        0, 0, kSimulatedTargetDepth_mm * settings.workspace.A_per_mm};  // the spheres lie on the circle of the hand
    tracker = methods().front().make(std::make_shared<const SphereGrid>(std::move(spheres)), kWaterProbe_A);
  }
  ServoSample tick() {
    const DevicePose pose = devices.read(kTick_s, step);
    const ServoSample sample = step.tick(settings, tracker.get(), pose);
    devices.write({sample.force});
    return sample;
  }
};

}  // namespace

TEST_CASE(
    "in 60 s the scripted hand touches for a third of the time or more, presses with 0.7 to 1.3 N, and repeats to the "
    "last bit") {
  const auto run = [](std::vector<Vec3>& forces) {
    Rig rig;
    int touching = 0, pressing = 0;
    for (int k = 0; k < 60'000; ++k) {
      const ServoSample s = rig.tick();
      forces.push_back(s.force.N);
      touching += s.contact.touching();
      const double size = glm::length(s.force.N);
      pressing += size > 0.7 && size < 1.3;
      REQUIRE(size < 2.5);
    }
    CHECK(touching > 20'000);
    CHECK(pressing > touching / 2);
  };
  std::vector<Vec3> first, second;
  run(first);
  run(second);
  CHECK(first == second);
}

TEST_CASE(
    "pulling the plug in contact: the mouse leads in the same tick, without force within 4 ms; back in, the stylus "
    "leads at once, softly") {
  Rig rig;
  int ticks = 0;
  while (glm::length(rig.tick().force.N) < 0.7 && ++ticks < 20'000) {
  }
  REQUIRE(ticks < 20'000);
  rig.mouse.place({{50, 0, 0}});
  rig.stylus.plug(false);
  CHECK_FALSE(rig.stylus.status().connected);
  ServoSample s = rig.tick();
  CHECK(rig.devices.fallenBack());
  CHECK(s.hand.mm == Vec3(50, 0, 0));
  CHECK(s.contact_reset);
  for (int k = 0; k < 3; ++k) s = rig.tick();
  CHECK(s.force.N == Vec3(0));
  for (int k = 0; k < 500; ++k) s = rig.tick();
  rig.stylus.plug(true);
  s = rig.tick();
  CHECK_FALSE(rig.devices.fallenBack());
  CHECK(s.contact_reset);
  CHECK(s.hand.mm != Vec3(50, 0, 0));
  CHECK(glm::length(s.force.N) < 0.01);
}
