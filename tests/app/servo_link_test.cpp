// The servo loop on the frames' clock and the haptic thread are equivalent: with the same script on a virtual clock,
// both make the same calls of the device.
#include "app/ui/scene/servo_link.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "app/ui/scene/view_controls.h"
#include "engine/haptics/methods.h"
#include "engine/servo/plain_trackers.h"
#include "tests/haptics/without_memory.h"

namespace moltact {
namespace {

constexpr std::int64_t kPeriod_ns = ServoLoop::kPeriod_ns;

// What a device is asked and given, a line a call.
struct Log {
  std::vector<std::string> calls;
  bool plugged = true;
  int reads = 0;
  ClockListener* clock = nullptr;  // called at each tick
};

class Logged final : public Device {
 public:
  explicit Logged(Log& log) : log_(log) {
    info_.name = "logged";
    info_.dof_in = 6;
    info_.dof_out = 3;
    info_.gives_force = true;
  }
  ~Logged() override { log_.calls.push_back("closed"); }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override {
    const double t = 0.001 * ++log_.reads;
    return {.position = {{4.0 * std::sin(2.0 * t), 0, -1.0 + 2.0 * std::cos(3.0 * t)}},
            .connected = log_.plugged,
            .orientation = glm::angleAxis(0.3 * std::sin(t), Vec3(0, 1, 0))};
  }
  void write(ForceN force) noexcept override {
    char text[120];
    std::snprintf(text, sizeof text, "%a %a %a", force.N.x, force.N.y, force.N.z);
    log_.calls.emplace_back(text);
  }
  void stop() noexcept override { log_.calls.push_back("stop"); }
  bool startClock(ClockListener& target) override {
    log_.clock = &target;
    return true;
  }
  void stopClock() override { log_.clock = nullptr; }

 private:
  DeviceInfo info_{shownForceFigures()};
  Log& log_;
};

// The virtual clock of the thread: it advances only with the owner, which makes the device tick.
std::atomic<std::int64_t> now_ns{0};
std::thread::id owner;
Log* ticked = nullptr;

std::int64_t virtualNow() { return now_ns.load(); }
void pass() {
  now_ns += kPeriod_ns;
  if (ticked->clock) ticked->clock->onDeviceTick();
}
void virtualSleep(std::int64_t due_ns) {
  if (std::this_thread::get_id() != owner) return sleepUntil(monotonic_ns() + kPeriod_ns);  // it only watches
  while (now_ns < due_ns) pass();
}

// What a script does to either.
struct Loop {
  std::function<void(const ServoSettings&)> settings;
  std::function<void(std::unique_ptr<Interaction>)> feel;
  std::function<bool(std::shared_ptr<const SphereMotion>)> move;
  std::function<void(std::unique_ptr<Device>)> hold;
  std::function<void(bool)> record;
  std::function<void()> end;
  std::function<void()> tick;
};

// Every way in which a force comes, is changed and ends.
void play(const Loop& loop, Log& log) {
  ServoSettings settings;
  const auto ticks = [&](int n, bool alive = true) {
    for (int k = 0; k < n; ++k) {
      if (alive) loop.settings(settings);
      loop.tick();
    }
  };
  const auto wall = [] { return std::make_unique<WallTracker>(0.0); };
  loop.hold(std::make_unique<Logged>(log));
  ticks(20);
  loop.feel(wall());
  ticks(1500);
  settings.panic = true;  // F9
  ticks(30);
  settings.panic = false;
  ticks(700);
  ticks(1400, false);  // the window hangs: the watchdog
  ticks(700);
  log.plugged = false;  // the mouse is the fallback
  ticks(60);
  log.plugged = true;
  ticks(700);
  settings.force_on = false;
  ticks(50);
  settings.force_on = true;
  ticks(600);
  loop.record(true);
  loop.feel(std::make_unique<ConstantForceTracker>(0.2));
  ticks(900);
  loop.record(false);
  ++settings.discontinuities;
  settings.workspace.A_per_mm = 0.2;
  loop.feel(wall());
  ticks(900);
  loop.hold(std::make_unique<Logged>(log));  // another device, from full force
  ticks(800);
  loop.feel(nullptr);
  ticks(20);
  loop.feel(wall());
  ticks(900);
  // A sphere that rises and sinks under the hand, frame by frame, as they are taken.
  std::vector<Sphere> sphere{{{0, 0, -3.0}, 1.6}};
  loop.feel(findMethod("exact")->make(std::make_shared<SphereGrid>(sphere), kWaterProbe_A));
  std::shared_ptr<const SphereMotion> next;
  for (int k = 0, begun = 0; k < 900; ++k) {
    if (!next) {
      const std::vector<Sphere> from = std::exchange(sphere, {{{0, 0, -3.0 + 0.3 * std::sin(0.5 * ++begun)}, 1.6}});
      next = *SphereMotion::make(from, sphere, 33);
    }
    if (loop.move(next)) next.reset();
    ticks(1);
  }
  loop.end();
  ticks(40);
}

std::vector<std::string> ofTheThread() {
  Log log;
  now_ns = 0;
  owner = std::this_thread::get_id();
  ticked = &log;
  {
    MouseDevice mouse;
    ServoThread thread(mouse, {&virtualNow, &virtualSleep});
    thread.loop().expectSettings();
    // Until a device brings its clock the thread's own would tick, by the wall's time: there is nothing to be felt yet.
    play({[&](const ServoSettings& s) { thread.loop().setSettings(s); },
          [&](std::unique_ptr<Interaction> felt) { thread.loop().setInteraction(std::move(felt)); },
          [&](std::shared_ptr<const SphereMotion> frame) { return thread.loop().setMotion(std::move(frame)); },
          [&](std::unique_ptr<Device> device) { thread.setDevice(std::move(device)); },
          [&](bool on) { thread.record(on); }, [&] { thread.endForce(); },
          [&] {
            pass();
            thread.loop().drain([](const ServoSample&) {});
          }},
         log);
  }
  ticked = nullptr;
  return log.calls;
}

std::vector<std::string> ofTheFrames() {
  Log log;
  {
    ServoLink link(ServoClock::Frames);
    play({[&](const ServoSettings& s) { link.loop().setSettings(s); },
          [&](std::unique_ptr<Interaction> felt) { link.setInteraction(std::move(felt)); },
          [&](std::shared_ptr<const SphereMotion> frame) { return link.setMotion(std::move(frame)); },
          [&](std::unique_ptr<Device> device) { link.setDevice(std::move(device)); }, [&](bool on) { link.record(on); },
          [&] { link.endForce(); }, [&] { link.advance(kTick_s); }},
         log);
  }
  return log.calls;
}

}  // namespace

TEST_CASE(
    "F9, a stalled window, unplugging, another device, another scene, a recording, moving spheres "
    "and the end: the thread and the frames make the same 11 000 calls of a device") {
  const std::vector<std::string> frames = ofTheFrames(), thread = ofTheThread();
  CHECK(frames.size() > 10'000);
  CHECK(frames.size() == thread.size());
  std::size_t stops = 0, forces = 0;
  for (std::size_t k = 0; k < std::min(frames.size(), thread.size()); ++k) {
    INFO("call " << k);
    REQUIRE(frames[k] == thread[k]);
    stops += frames[k] == "stop";
    forces += frames[k] != "stop" && frames[k] != "closed" && frames[k] != "0x0p+0 0x0p+0 0x0p+0";
  }
  CHECK(stops >= 30);
  CHECK(forces > 4'000);
}

TEST_CASE(
    "a body in the hand is turned by mouse and keys: 100 px to the right and 0.5 s of an arrow up turn it by 0.8 and "
    "-0.7 rad; a point and a new scene are not turned") {
  struct Body final : test::WithoutMemory<Tracker> {
    Contact step(PointA hip) noexcept override { return {.scp = hip}; }
    bool hasOrientation() const noexcept override { return true; }
  };
  ServoLink link(ServoClock::Frames);
  link.setInteraction(std::make_unique<WallTracker>(0.0));
  CHECK_FALSE(link.loop().hasOrientation());
  link.setInteraction(std::make_unique<Body>());
  REQUIRE(link.loop().hasOrientation());
  const SphereGrid spheres({{{0, 0, 0}, 1.6}});
  ServoSettings settings;
  // The device's axes are the molecule's turned by a quarter round z; the camera looks as it is made.
  settings.workspace.rotation = glm::dmat3(Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1));
  link.loop().setSettings(settings);
  ViewControls controls;
  Camera camera;
  controls.begin(camera, {}, settings.workspace, 10.0, link.mouse());
  link.advance(0.2);
  ViewInput drag, key;
  drag.size_px = key.size_px = {800, 600};
  drag.hand_px = {100, 0};
  key.hand_keys = {0, 1};
  key.dt_s = 0.01;
  controls.update(drag, camera, &spheres, settings, {}, link.mouse());
  link.advance(0.5);
  // Of the pose in the molecule's space: first the device's own quarter, then 0.8 rad round the screen's upright axis.
  const Quat quarter = glm::quat_cast(settings.workspace.rotation);
  CHECK(glm::length(rotationBetween(glm::angleAxis(0.8, camera.up()) * quarter, link.newest().orientation)) < 1e-3);
  for (int k = 0; k < 50; ++k) controls.update(key, camera, &spheres, settings, {}, link.mouse());
  link.advance(0.5);
  const Quat both = glm::angleAxis(-0.7, camera.right()) * glm::angleAxis(0.8, camera.up()) * quarter;
  CHECK(glm::length(rotationBetween(both, link.newest().orientation)) < 1e-3);
  controls.begin(camera, {}, settings.workspace, 10.0, link.mouse());
  link.advance(0.8);
  CHECK(glm::length(rotationBetween(quarter, link.newest().orientation)) < 1e-3);
}

}  // namespace moltact
