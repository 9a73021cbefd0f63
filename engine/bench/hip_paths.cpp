#include "engine/bench/hip_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/sweep.h"

namespace moltact::bench {
namespace {

constexpr double kPathStep_A = 0.02;

Vec3 randomDirection(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

Vec3 middle(const SphereGrid& scene) { return 0.5 * (scene.low_A() + scene.high_A()); }

}  // namespace

std::vector<Sphere> proteinLike(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> shift(-0.9, 0.9), radius(1.5, 1.9);
  const double spacing = std::cbrt(1.0 / 0.06);
  const double reach = std::cbrt(double(count) / 0.06 * 3.0 / (4.0 * std::numbers::pi));
  const int n = static_cast<int>(std::ceil(reach / spacing)) + 1;
  std::vector<std::pair<double, Sphere>> all;
  for (int x = -n; x <= n; ++x)
    for (int y = -n; y <= n; ++y)
      for (int z = -n; z <= n; ++z) {
        const Vec3 c = Vec3(x, y, z) * spacing + Vec3(shift(random), shift(random), shift(random));
        all.push_back({glm::length(c), {c, radius(random)}});
      }
  std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(count) - 1, all.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Sphere> spheres(count);
  for (std::size_t i = 0; i < count; ++i) spheres[i] = all[i].second;
  return spheres;
}

std::vector<Vec3> slidingPath(const std::shared_ptr<const SphereGrid>& scene, double probe_A, double depth_A,
                              std::size_t ticks, unsigned seed) {
  std::mt19937_64 random(seed);
  ExactTracker guide(scene, probe_A);
  const Vec3 centre = middle(*scene);
  Vec3 h = centre + Vec3(glm::length(scene->high_A() - scene->low_A()), 0, 0);
  guide.step({h});
  std::vector<Vec3> path;
  Vec3 heading = randomDirection(random);
  bool reached = false;
  while (path.size() < ticks) {
    const Contact c = guide.step({h});
    Vec3 direction = centre - h;
    if (c.touching()) {
      const Vec3 lift = c.scp.A - h;
      const double depth = glm::length(lift);
      const Vec3 out = lift / depth;
      heading = glm::normalize(heading + 0.05 * randomDirection(random));
      heading = glm::normalize(heading - out * glm::dot(heading, out));
      direction = heading + out * (3.0 * (depth - depth_A));
      reached = reached || depth >= depth_A;
    }
    // The approach from outside is not part of the path.
    h += glm::normalize(direction) *
         (reached || c.touching() ? kPathStep_A : std::max(kPathStep_A, 0.9 * clearance(*scene, probe_A, h)));
    if (reached) path.push_back(h);
  }
  return path;
}

std::vector<Vec3> freePath(const std::shared_ptr<const SphereGrid>& scene, double probe_A, std::size_t ticks,
                           unsigned seed) {
  std::mt19937_64 random(seed);
  const Vec3 centre = middle(*scene);
  Vec3 h = centre + Vec3(glm::length(scene->high_A() - scene->low_A()), 0, 0);
  for (double gap; (gap = clearance(*scene, probe_A, h)) > 2.0;) h += glm::normalize(centre - h) * (0.5 * gap);
  std::vector<Vec3> path;
  Vec3 heading = randomDirection(random);
  while (path.size() < ticks) {
    heading = glm::normalize(heading + 0.05 * randomDirection(random));
    const double gap = clearance(*scene, probe_A, h);
    const Vec3 out = glm::normalize(h - centre);
    const Vec3 next = h + kPathStep_A * glm::normalize(heading + out * (gap < 0.5 ? 2.0 : gap > 3.0 ? -2.0 : 0.0));
    if (clearance(*scene, probe_A, next) > 0.05)
      h = next;
    else
      heading = randomDirection(random);
    path.push_back(h);
  }
  return path;
}

}  // namespace moltact::bench
