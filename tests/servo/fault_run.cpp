#include "tests/servo/fault_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/workspace/scale.h"
#include "tests/servo/fault_world.h"

namespace moltact::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// What each fault does to the world; `some` is a number from 1 to 60, for how long or which kind.

void late(FaultWorld& w, int some) {
  for (int k = 0; k < some; ++k) {
    const int late = int(w.random.uniform(0, 15));
    w.idle(late);
    w.tick({.time = {.dt_s = 0.001 * (late + 1), .delay_s = w.random.uniform(0, 0.003)}});
  }
}

// The loop stalls for a random time.
void stalled(FaultWorld& w, double least_ms, double most_ms) {
  const int ms = int(w.random.uniform(least_ms, most_ms));
  w.idle(ms);
  w.expectSoft();
  w.tick({.time = {.dt_s = 0.001 * ms}});
}
void stall(FaultWorld& w, int) { stalled(w, 21, 99); }
void longStall(FaultWorld& w, int) { stalled(w, 101, 3000); }

void doubled(FaultWorld& w, int some) {
  for (int k = 0; k < some; ++k) {
    w.tick({.time = {.dt_s = 0}, .moves = false});
    w.tick();
  }
}

void clockBack(FaultWorld& w, int) {
  w.expectSoft();
  w.tick({.time = {.dt_s = -w.random.uniform(1e-6, 1e6)}});
}

void clockAhead(FaultWorld& w, int) {
  w.expectSoft();
  w.tick({.time = {.dt_s = w.random.uniform(0.021, 1e9)}});
}

void clockNaN(FaultWorld& w, int some) {
  w.expectSoft();
  w.tick({.time = {.dt_s = some % 2 ? kNaN : kInfinity, .delay_s = kNaN}});
}

void teleport(FaultWorld& w, int some) {
  w.expectSoft();
  for (int k = 0; k < some % 5 + 1; ++k)
    w.tick({.place_mm = w.placed().mm + w.random.direction() * w.random.uniform(8, 200), .leaps = k == 0});
  w.expectSoft();
}

void placeNaN(FaultWorld& w, int some) {
  w.lasting(some * 4, {.place_mm = some % 3 ? Vec3(kNaN, 0, 0) : Vec3(0, kInfinity, -kInfinity)});
}

void stale(FaultWorld& w, int some) {
  const Vec3 frozen = w.placed().mm;
  w.ticks(some * 5, {.place_mm = frozen, .fresh = false});
}

void unplug(FaultWorld& w, int some) { w.lasting(some * 20, {.connected = false}); }

// Nobody writes settings or leads the hand for 5 s.
void rendererStalls(FaultWorld& w, int) { w.ticks(5000); }

void sceneSwap(FaultWorld& w, int) {
  w.expectSoft();
  w.newScene();
  ++w.settings.discontinuities;
  w.tick();
}

void methodSwap(FaultWorld& w, int) {
  w.expectSoft();
  w.newTracker();
  w.tick();
}

void badSettings(FaultWorld& w, int some) {
  const ServoSettings kept = w.settings;
  const std::array<double, 6> bad{kNaN, kInfinity, -kInfinity, -1.0, 1e300, 0.0};
  const auto pick = [&] { return bad[std::size_t(w.random.uniform(0, 5.999))]; };
  w.settings.stiffness_N_per_mm = pick();
  w.settings.max_force_N = pick();
  w.settings.probe_A = pick();
  if (some % 3 == 0) w.settings.workspace.A_per_mm = some % 2 ? kNaN : 0.0;
  w.unsound_settings = true;
  w.ticks(some * 3);
  w.unsound_settings = false;
  w.settings = kept;
}

void probeJump(FaultWorld& w, int some) {
  w.settings.probe_A = w.random.uniform(0.5, 2.5);
  w.ticks(some * 3);
  w.settings.probe_A = kWaterProbe_A;
}

void panic(FaultWorld& w, int some) {
  w.settings.panic = true;
  w.ticks(some * 10);
  w.settings.panic = false;
  w.expectSoft();
}

void forceOff(FaultWorld& w, int some) {
  w.settings.force_on = false;
  w.lasting(some * 10, {});
  w.settings.force_on = true;
}

void badTracker(FaultWorld& w, int some) {
  w.expectSoft();
  w.bad = std::make_unique<BadTracker>(some % 3 == 0   ? Vec3(kNaN, kNaN, kNaN)
                                       : some % 3 == 1 ? Vec3(1e300, 0, 0)
                                                       : Vec3(0, -kInfinity, 0));
  w.ticks(some * 3);
  w.bad.reset();
  w.expectSoft();
  w.tick();
}

// A part is magnified, or no longer.
void magnified(FaultWorld& w, int some) {
  w.expectSoft();
  const Workspace kept = w.settings.workspace;
  w.settings.workspace =
      rescaled(kept, kept.A_per_mm * (some % 2 ? 0.4 : 1.5), w.sensed(), kept.toMolecule(w.sensed()));
  w.ticks(some * 3);
  w.expectSoft();
  w.settings.workspace = rescaled(kept, kept.A_per_mm, w.sensed(), w.settings.workspace.toMolecule(w.sensed()));
  w.ticks(some * 3);
}

// The stylus is disconnected, a mouse presses arbitrarily deep, the stylus reconnects.
void fallBack(FaultWorld& w, int some) {
  w.otherDevice(DeviceInfo{shownForceFigures()});
  const Vec3 deep = w.sensed().mm * w.random.uniform(0.2, 1.0);
  for (int k = 0; k < some * 20; ++k)
    w.tick({.place_mm = deep + (w.sensed().mm - deep) * std::exp(-0.01 * k), .to_model = false});
  w.otherDevice(w.info());
  w.ticks(some * 3);
}

// A weaker one is plugged in, and the first one again.
void weakDevice(FaultWorld& w, int some) {
  DeviceInfo weak = w.info();
  weak.max_force_N = 1.0;
  w.otherDevice(weak);
  w.ticks(some * 10);
  w.otherDevice(w.info());
  w.ticks(some * 3);
}

// Stopped, unplugged, allowed again while it is away.
void panicUnplugged(FaultWorld& w, int some) {
  w.settings.panic = true;
  w.ticks(some);
  w.expectSoft();
  w.ticks(some, {.connected = false});
  w.settings.panic = false;
  w.lasting(some * 5, {.connected = false});
}

// Another molecule, spring, probe and scale in one tick.
void lessonSwap(FaultWorld& w, int some) {
  w.expectSoft();
  w.settings.probe_A = w.random.uniform(0.5, 2.5);
  w.settings.stiffness_N_per_mm = w.random.uniform(0.1, 2.0);
  w.settings.workspace.A_per_mm = w.random.uniform(0.1, 0.4);
  w.newScene();
  ++w.settings.discontinuities;
  w.ticks(some * 3);
}

void orientationLeap(FaultWorld& w, int) {
  w.expectSoft();
  w.tick({.orientation = glm::angleAxis(1.5, w.random.direction()) * w.orientation(), .leaps = true});
  w.expectSoft();
  w.tick({.leaps = true});
  w.expectSoft();
}

void orientationNaN(FaultWorld& w, int some) {
  w.lasting(some * 4, {.orientation = some % 2 ? Quat(kNaN, 0, 0, 0) : Quat(3, 0, 0, 0)});
}

// The sphere nearest to the hand, by 3 A at it or across it, at once or within a frame.
void atomLeaps(FaultWorld& w, int some) {
  const Vec3 hip = w.settings.workspace.toMolecule(w.sensed()).A;
  std::vector<Sphere> to = w.spheres();
  const auto near = std::min_element(to.begin(), to.end(), [&](const Sphere& a, const Sphere& b) {
    return glm::distance(a.centre_A, hip) - a.radius_A < glm::distance(b.centre_A, hip) - b.radius_A;
  });
  const Vec3 at_it = hip - near->centre_A;
  near->centre_A += 3.0 * (some % 2 && glm::length(at_it) > 0.1 ? glm::normalize(at_it) : w.random.direction());
  w.moveSpheres(to, some % 3 == 0 ? 1 : 33);
}

// Every sphere by up to 1 A and a tenth of its radius, frame after frame.
void proteinShakes(FaultWorld& w, int some) {
  const std::vector<Sphere> rest = w.spheres();
  for (int k = 0; k < 1 + some / 3; ++k) {
    std::vector<Sphere> to = rest;
    for (Sphere& sphere : to) {
      sphere.centre_A += w.random.direction() * w.random.uniform(0, 1.0);
      sphere.radius_A *= w.random.uniform(0.9, 1.1);
    }
    w.moveSpheres(to, 33);
  }
}

struct Fault {
  const char* name;
  void (*done_to)(FaultWorld&, int some);
};
constexpr Fault kFaults[] = {{"late", late},
                             {"stall", stall},
                             {"long stall", longStall},
                             {"doubled", doubled},
                             {"clock back", clockBack},
                             {"clock ahead", clockAhead},
                             {"clock NaN", clockNaN},
                             {"teleport", teleport},
                             {"place NaN", placeNaN},
                             {"stale", stale},
                             {"unplug", unplug},
                             {"renderer stalls", rendererStalls},
                             {"scene swap", sceneSwap},
                             {"method swap", methodSwap},
                             {"bad settings", badSettings},
                             {"probe jump", probeJump},
                             {"panic", panic},
                             {"force off", forceOff},
                             {"bad tracker", badTracker},
                             {"rescaled", magnified},
                             {"fall back", fallBack},
                             {"weak device", weakDevice},
                             {"panic unplugged", panicUnplugged},
                             {"lesson swap", lessonSwap},
                             {"orientation leap", orientationLeap},
                             {"orientation NaN", orientationNaN},
                             {"atom leaps", atomLeaps},
                             {"protein shakes", proteinShakes}};

}  // namespace

FaultRunResult runFaults(std::uint64_t seed, int faults) {
  FaultWorld world(seed);
  for (int k = 0; k < faults && world.result().broken.empty(); ++k) {
    world.approach();
    const Fault& fault = kFaults[std::size_t(int(world.random.uniform(0, double(std::size(kFaults))) * 0.999999))];
    world.begin(fault.name);
    fault.done_to(world, 1 + int(world.random.uniform(0, 60)));
    world.restAfter();
  }
  return world.result();
}

}  // namespace moltact::test
