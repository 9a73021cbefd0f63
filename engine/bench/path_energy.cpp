#include "engine/bench/path_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bench/oracle.h"
#include "engine/bench/passivity_observer.h"
#include "engine/haptics/exact/exact_tracker.h"

namespace moltact::bench {
namespace {
constexpr double kWayBack_A = 0.01;  // per tick
constexpr double kJump = 4;          // times stiffness times distance: no surface changes the force faster
}  // namespace

double madeAlong(Tracker& tracker, const scenes::Scene& scene, const scenes::Path& path, const LoopSettings& loop) {
  if (path.empty()) return 0;
  PassivityObserver observer;
  const auto forceAt = [&](const Vec3& hip, bool& touching) {
    const Contact c = tracker.step({hip});
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
    const Vec3 moved_m = 1e-3 * (loop.workspace.toDevice({next}).mm - loop.workspace.toDevice({here}).mm);
    // Without contact since then no energy was exchanged, and the previous release is still valid.
    const bool released = !touching && was_touching && outside(next);
    // The position of a jump within a tick is unknown: only the smaller of both forces is counted.
    const double way_N = 1e3 * loop.stiffness_N_per_mm * glm::length(moved_m);
    const bool jumped = glm::distance(before, force) > kJump * way_N;
    const Vec3 lesser = glm::dot(before, moved_m) < glm::dot(force, moved_m) ? before : force;
    observer.add(jumped ? lesser : 0.5 * (before + force), moved_m, released);
    was_touching = touching || (was_touching && !released);
    here = next;
  }
  return observer.made_J();
}

double madeOverClosedPath(const std::function<std::unique_ptr<Tracker>()>& make, const scenes::Scene& scene,
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

}  // namespace moltact::bench
