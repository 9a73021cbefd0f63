// The haptic thread: handing over trackers and samples. Independent of the machine's timing.
#include "engine/servo/servo_thread.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "engine/device/simulated_device.h"
#include "engine/haptics/tracker.h"
#include "tests/haptics/without_memory.h"
#include "tests/servo/newest_tick.h"

using namespace moltact;

namespace {

// A device whose hand is at rest and that counts its outputs.
class StillDevice final : public Device {
 public:
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override { return {.position = {{1, 2, 3}}}; }
  void write(ForceN force) noexcept override {
    last_x_N.store(force.N.x);
    writes.fetch_add(1);
  }
  std::atomic<double> last_x_N{-1};
  std::atomic<long> writes{0};

 private:
  DeviceInfo info_{shownForceFigures()};
};

// A device that ticks the loop by a thread of its own.
class ClockedDevice final : public Device {
 public:
  explicit ClockedDevice(std::chrono::milliseconds pause = std::chrono::milliseconds(2)) : pause_(pause) {}
  ~ClockedDevice() override { stopClock(); }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override { return {.position = {{4, 5, 6}}}; }
  void write(ForceN force) noexcept override { last_x_N.store(force.N.x); }
  bool startClock(ClockListener& target) override {
    ends_.store(false);
    clock_ = std::thread([this, &target] {
      while (!ends_.load()) {
        if (!stopped.load()) {
          target.onDeviceTick();
          own_ticks.fetch_add(1);
        }
        std::this_thread::sleep_for(pause_);
      }
    });
    return true;
  }
  void stopClock() override {
    ends_.store(true);
    if (clock_.joinable()) clock_.join();
  }
  std::atomic<double> last_x_N{-1};
  std::atomic<long> own_ticks{0};
  std::atomic<bool> stopped{false};

 private:
  DeviceInfo info_{shownForceFigures()};
  const std::chrono::milliseconds pause_;
  std::atomic<bool> ends_{false};
  std::thread clock_;
};

// A tracker that always pushes along x and records the thread of its destruction.
class PushingTracker final : public test::WithoutMemory<Tracker> {
 public:
  explicit PushingTracker(std::atomic<int>& alive, std::thread::id& destroyed_on)
      : alive_(alive), destroyed_on_(destroyed_on) {
    ++alive_;
  }
  ~PushingTracker() override {
    --alive_;
    destroyed_on_ = std::this_thread::get_id();
  }
  Contact step(PointA hip) noexcept override {
    Contact out{.scp = {hip.A + Vec3(0.1, 0, 0)}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    stretchToScp(out, hip);
    return out;
  }

 private:
  std::atomic<int>& alive_;
  std::thread::id& destroyed_on_;
};

// A tracker whose SCP identifies it.
class MarkedTracker final : public test::WithoutMemory<Tracker> {
 public:
  explicit MarkedTracker(std::uint32_t mark) : mark_(mark) {}
  Contact step(PointA hip) noexcept override {
    Contact out{.scp = {Vec3(double(mark_), 0, 0)}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    stretchToScp(out, hip);
    return out;
  }

 private:
  std::uint32_t mark_;
};

}  // namespace

TEST_CASE("the loop runs, numbers its ticks without a gap and leaves the device without force at the end") {
  StillDevice device;
  std::atomic<int> alive{0};
  std::thread::id destroyed_on;
  {
    ServoThread servo(device);
    servo.loop().setInteraction(std::make_unique<PushingTracker>(alive, destroyed_on));
    std::uint64_t next = 0;
    long seen = 0;
    while (seen < 300) {
      servo.loop().drain([&](const ServoSample& s) {
        CHECK(s.tick == next);
        next = s.tick + 1;
        ++seen;
      });
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(device.last_x_N.load() > 0.0);
  }
  CHECK(device.last_x_N.load() == 0.0);
  CHECK(alive == 0);
}

TEST_CASE("50 trackers handed over one after the other are all destroyed, and by the thread that handed them over") {
  StillDevice device;
  std::atomic<int> alive{0};
  std::thread::id destroyed_on;
  ServoThread servo(device);
  test::NewestTick newest(servo.loop());
  for (int k = 0; k < 50; ++k) {
    servo.loop().setInteraction(std::make_unique<PushingTracker>(alive, destroyed_on));
    if (k % 3 == 0) newest.wait(2);
  }
  servo.loop().setInteraction(nullptr);
  for (int k = 0; k < 1000 && alive > 0; ++k) newest.wait(2);
  CHECK(alive == 0);
  CHECK(destroyed_on == std::this_thread::get_id());
  CHECK_FALSE(newest().has_interaction);
}

TEST_CASE("each of 40 trackers makes the samples that bear its number, and none under settings older than its own") {
  StillDevice device;
  ServoThread servo(device);
  std::uint32_t scene = 0, felt_scene = 0;
  long judged = 0;
  const auto judge = [&](const ServoSample& s) {
    felt_scene = s.scene;
    if (s.scene == 0) return;
    CHECK(s.contact.scp.A.x == double(s.scene));
    CHECK(s.discontinuities >= s.scene);
    ++judged;
  };
  for (int k = 0; k < 40; ++k) {
    ServoSettings settings;
    settings.discontinuities = ++scene;
    servo.loop().setSettings(settings);
    servo.loop().setInteraction(std::make_unique<MarkedTracker>(scene), scene);
    while (felt_scene != scene) {
      servo.loop().drain(judge);
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
  }
  CHECK(judged >= 40);
}

TEST_CASE("a device that is chosen leads, one whose plug is pulled gives way to the fallback, and comes back") {
  StillDevice fallback;
  ServoThread servo(fallback);
  test::NewestTick newest(servo.loop());
  servo.loop().setInteraction(std::make_unique<MarkedTracker>(1));
  auto made = std::make_unique<SimulatedDevice>();
  SimulatedDevice* stylus = made.get();
  servo.setDevice(std::move(made));
  CHECK(servo.loop().device() == stylus);
  newest.wait(20);
  CHECK(newest().hand.mm != Vec3(1, 2, 3));
  CHECK_FALSE(servo.loop().fallenBack());
  stylus->plug(false);
  newest.wait(20);
  CHECK(newest().hand.mm == Vec3(1, 2, 3));
  CHECK(servo.loop().fallenBack());
  stylus->plug(true);
  newest.wait(20);
  CHECK_FALSE(servo.loop().fallenBack());
  servo.setDevice(nullptr);
  newest.wait(20);
  CHECK(newest().hand.mm == Vec3(1, 2, 3));
  CHECK(fallback.last_x_N.load() != 0.0);
}

TEST_CASE("a device with its own clock ticks the loop by it; when that clock stops, the loop's own takes over") {
  StillDevice fallback;
  ServoThread servo(fallback);
  auto made = std::make_unique<ClockedDevice>();
  ClockedDevice* clocked = made.get();
  servo.setDevice(std::move(made));
  while (clocked->own_ticks.load() < 50) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  // It ticks every 2 ms: a millisecond late, at the least, but where the loop's own clock stood in.
  std::size_t reported = 0, late = 0;
  PointMm last;
  servo.loop().drain([&](const ServoSample& s) {
    last = s.hand;
    if (s.hand.mm != Vec3(4, 5, 6)) return;
    ++reported;
    late += s.late_us >= 900.0f;
  });
  CHECK(last.mm == Vec3(4, 5, 6));
  CHECK(reported > 40);
  CHECK(2 * late > reported);
  clocked->stopped.store(true);
  test::NewestTick newest(servo.loop());
  const long then = clocked->own_ticks.load();
  newest.wait(50);
  CHECK(clocked->own_ticks.load() <= then + 1);
  servo.setDevice(nullptr);
  newest.wait(5);
  CHECK(newest().hand.mm == Vec3(1, 2, 3));
}

TEST_CASE(
    "no sample is read for 6000 ticks, as when the window stalls: the loop continues, the force too, "
    "and 4096 ticks are kept complete") {
  StillDevice fallback;
  std::atomic<int> alive{0};
  std::thread::id destroyed_on;
  ServoThread servo(fallback);
  servo.loop().setInteraction(std::make_unique<PushingTracker>(alive, destroyed_on));
  auto made = std::make_unique<ClockedDevice>(std::chrono::milliseconds(0));
  ClockedDevice* clocked = made.get();
  servo.setDevice(std::move(made));
  while (clocked->own_ticks.load() < 6000) std::this_thread::yield();
  CHECK(clocked->last_x_N.load() >= 0.0);
  std::uint64_t first = 0, last = 0;
  std::size_t waiting = 0;
  bool whole = true;
  servo.loop().drain([&](const ServoSample& s) {
    if (waiting++ == 0)
      first = s.tick;
    else
      whole = whole && s.tick > last;
    last = s.tick;
  });
  CHECK(waiting >= 4096);
  CHECK(whole);
  CHECK(last > first);
  test::NewestTick newest(servo.loop());
  newest.wait(1);
  CHECK(newest().tick >= 5900);
  CHECK(newest().contact.touching());
}

TEST_CASE("values handed over 100 000 times arrive whole and never go back") {
  struct Pair {
    long a = 0, b = 0;
  };
  TripleBuffer<Pair> buffer;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (long k = 1; k <= 100'000; ++k) buffer.write({k, -k});
    done = true;
  });
  long last = 0, torn = 0, backward = 0;
  while (!done || last < 100'000) {
    const Pair& p = buffer.read();
    torn += p.a != -p.b;
    backward += p.a < last;
    last = p.a;
  }
  writer.join();
  CHECK(torn == 0);
  CHECK(backward == 0);
}

TEST_CASE("a ring of 4 takes 4 samples, drops and counts the fifth, and gives them back in order") {
  SampleRing<int, 4> ring;
  for (int k = 0; k < 4; ++k) CHECK(ring.push(k));
  CHECK_FALSE(ring.push(4));
  CHECK(ring.dropped() == 1);
  int value = -1;
  for (int k = 0; k < 4; ++k) {
    CHECK(ring.pop(value));
    CHECK(value == k);
  }
  CHECK_FALSE(ring.pop(value));
}

TEST_CASE(
    "an owner that stops handing over, such as a stalled window, cannot keep the force on: after 1 s "
    "there is none, and with the next settings it returns") {
  std::atomic<int> alive{0};
  std::thread::id destroyed_on;
  StillDevice device;
  ServoThread servo(device);
  servo.loop().expectSettings();
  servo.loop().setInteraction(std::make_unique<PushingTracker>(alive, destroyed_on));
  const auto until = [&](auto&& holds) {
    for (int k = 0; k < 3000 && !holds(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return holds();
  };
  CHECK(until([&] { return servo.loop().setSettings({}), device.last_x_N.load() > 0.1; }));
  CHECK(until([&] { return device.last_x_N.load() == 0.0; }));
  const long ticks = device.writes.load();
  CHECK(until([&] { return device.writes.load() > ticks + 200; }));
  CHECK(device.last_x_N.load() == 0.0);
  CHECK(until([&] { return servo.loop().setSettings({}), device.last_x_N.load() > 0.1; }));
}
