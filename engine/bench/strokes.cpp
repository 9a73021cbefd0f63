#include "engine/bench/strokes.h"

#include <algorithm>
#include <cmath>

#include "engine/bench/hip_paths.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/sweep.h"

namespace moltact::bench {

std::vector<Stroke> contactStrokes(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                   const StrokePlan& plan) {
  scenes::Random random(plan.seed);
  ExactTracker guide(scene, probe_A);
  const Vec3 centre = 0.5 * (scene->low_A() + scene->high_A());
  const double far = glm::length(scene->high_A() - scene->low_A()) + 2 * probe_A + 1;
  std::vector<Stroke> out;
  while (out.size() < plan.strokes) {
    Stroke one;
    guide.reset();
    Vec3 h = centre + random.direction() * far;
    const Vec3 aim = (centre - h) / glm::distance(centre, h);
    Vec3 heading = random.direction();
    for (bool reached = false; one.counted.size() < plan.ticks;) {
      const Contact c = guide.step({h});
      (reached ? one.counted : one.approach).push_back(h);
      if (!c.touching()) {
        if (reached || glm::dot(h - centre, aim) > far) break;  // lost contact or passed through: another side
        h += aim * std::max(kStrokeStep_A, 0.9 * clearance(*scene, probe_A, h));
        continue;
      }
      const Vec3 lift = c.scp.A - h;
      const double depth = glm::length(lift);
      const Vec3 up = lift / depth;
      reached = reached || depth >= plan.depth_A;
      heading = glm::normalize(heading + 0.05 * random.direction());
      heading = glm::normalize(heading - up * glm::dot(heading, up));
      h += kStrokeStep_A * (reached ? glm::normalize(heading + up * (3.0 * (depth - plan.depth_A))) : -up);
    }
    if (one.counted.size() == plan.ticks) out.push_back(std::move(one));
  }
  return out;
}

std::vector<Stroke> freeStrokes(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                const StrokePlan& plan) {
  const std::vector<Vec3> path = freePath(scene, probe_A, plan.strokes * plan.ticks, static_cast<unsigned>(plan.seed));
  std::vector<Stroke> out(plan.strokes);
  for (std::size_t k = 0; k < plan.strokes; ++k) {
    const auto begin = path.begin() + static_cast<std::ptrdiff_t>(k * plan.ticks);
    out[k].approach = {*begin};
    out[k].counted.assign(begin, begin + static_cast<std::ptrdiff_t>(plan.ticks));
  }
  return out;
}

}  // namespace moltact::bench
