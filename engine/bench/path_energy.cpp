#include "engine/bench/path_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/bench/oracle.h"
#include "engine/bench/passivity_observer.h"
#include "engine/haptics/exact/exact_tracker.h"

namespace moltact::bench {
namespace {
constexpr double kWayBack_A = 0.01;  // per tick
constexpr double kJump = 4;          // times stiffness times distance: no surface changes the force faster

Vec3 metres(const LoopSettings& loop, const Vec3& from_A, const Vec3& to_A) {
  return 1e-3 * (loop.workspace.toDevice({to_A}).mm - loop.workspace.toDevice({from_A}).mm);
}

// The mean of the forces before and after a motion. The position of a jump within a tick is unknown: only the smaller of
// both forces is counted.
Vec3 meanForce(const LoopSettings& loop, const Vec3& before, const Vec3& after, const Vec3& moved_m) {
  const double way_N = 1e3 * loop.stiffness_N_per_mm * glm::length(moved_m);
  if (glm::distance(before, after) <= kJump * way_N) return 0.5 * (before + after);
  return glm::dot(before, moved_m) < glm::dot(after, moved_m) ? before : after;
}

}  // namespace

double madeAlong(Interaction& felt, const scenes::Scene& scene, const scenes::Path& path, const LoopSettings& loop) {
  if (path.empty()) return 0;
  PassivityObserver observer;
  const auto forceAt = [&](const Vec3& hip, bool& touching) {
    const Contact c = felt.respond({{hip}, kNoRotation}).contact;
    touching = c.touching();
    return springForce(loop, c, std::numeric_limits<double>::infinity()).N;
  };
  const auto outside = [&](const Vec3& hip) { return oracle::deepest(scene.spheres, scene.probe_A, hip) <= 0; };
  bool touching = false;
  Vec3 here = path.front(), force = forceAt(here, touching);
  if (!touching && outside(here)) observer.release();
  bool was_touching = touching;
  for (const Vec3& next : path) {
    const Vec3 before = force;
    force = forceAt(next, touching);
    const Vec3 moved_m = metres(loop, here, next);
    // Without contact since then no energy was exchanged, and the previous release is still valid.
    const bool released = !touching && was_touching && outside(next);
    observer.add(meanForce(loop, before, force, moved_m), moved_m, released);
    was_touching = touching || (was_touching && !released);
    here = next;
  }
  return observer.made_J();
}

double madeOverClosedPath(const std::function<std::unique_ptr<Interaction>()>& make, const scenes::Scene& scene,
                          const scenes::Path& path, const LoopSettings& loop) {
  if (path.empty()) return 0;
  ExactTracker guide(std::make_shared<const SphereGrid>(scene.spheres), scene.probe_A);
  scenes::Path surface;
  surface.reserve(path.size());
  for (const Vec3& h : path) surface.push_back(guide.step({h}).scp.A);

  scenes::Path round = path;
  for (std::size_t k = surface.size(); k-- > 0;) {
    const Vec3 from = round.back();
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::distance(from, surface[k]) / kWayBack_A)));
    for (int piece = 1; piece <= pieces; ++piece)
      round.push_back(from + (surface[k] - from) * (double(piece) / pieces));
  }
  // The SCP's path ends where the path begins; a method with an inaccurate surface may still touch there.
  double made = madeAlong(*make(), scene, round, loop);
  std::reverse(round.begin(), round.end());
  return std::max(made, madeAlong(*make(), scene, round, loop));
}

double madeOverMoving(Interaction& felt, const scenes::Scene& scene, const std::vector<MotionPhase>& phases,
                      const scenes::Path& path, const LoopSettings& loop) {
  if (path.empty()) return 0;
  // Of one spring at an extension of 1 A (unit: joule).
  const double J_per_A2 = 1e-3 * loop.stiffness_N_per_mm / (loop.workspace.A_per_mm * loop.workspace.A_per_mm);
  std::vector<Sphere> spheres = scene.spheres;
  PassivityObserver observer;
  struct Felt {
    Vec3 force_N{0.0};
    double stored_J = 0;
    bool touching = false;
  };
  const auto feel = [&](const Vec3& hip) {
    const Contact c = felt.respond({{hip}, kNoRotation}).contact;
    return Felt{springForce(loop, c, std::numeric_limits<double>::infinity()).N, c.energy_A2 * J_per_A2, c.touching()};
  };
  double surface_J = 0, counted_J = 0;  // the work of the surface, and what of it the observer knows
  Vec3 here = path.front();
  Felt last;
  bool was_touching = true;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const MotionPhase phase = k < phases.size() ? phases[k] : phases.empty() ? MotionPhase{} : phases.back();
    if (phase.motion) {
      if (k < phases.size()) spheres = phase.motion->at(phase.fraction);
      if (felt.setMotion(phase.motion)) felt.advanceTo(phase.fraction);
      const Felt moved = feel(here);
      surface_J += moved.stored_J - last.stored_J;
      last = moved;
    }
    const Felt now = feel(path[k]);
    const Vec3 moved_m = metres(loop, here, path[k]);
    const bool outside = oracle::deepest(spheres, scene.probe_A, path[k]) <= 0;
    const bool released = !now.touching && was_touching && outside;
    observer.add(meanForce(loop, last.force_N, now.force_N, moved_m), moved_m, false);
    // What the surface has put in is taken off what the hand has received.
    observer.addWork(std::exchange(counted_J, surface_J) - surface_J, released);
    was_touching = now.touching || (was_touching && !released);
    here = path[k];
    last = now;
  }
  return observer.made_J();
}

}  // namespace moltact::bench
