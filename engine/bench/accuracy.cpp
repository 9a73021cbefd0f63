#include "engine/bench/accuracy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/bench/oracle.h"
#include "engine/haptics/exact/exact_tracker.h"

namespace moltact::bench {
namespace {

struct Errors {
  std::vector<double> scp, direction;
  std::size_t lost = 0;

  void add(const Vec3& hip, const Contact& c, const Vec3& right) {
    scp.push_back(glm::distance(c.scp.A, right));
    if (c.touching())
      direction.push_back(angle_deg(c.displacement_A, right - hip));
    else
      ++lost;
  }
  Accuracy result() && {
    Accuracy a;
    a.lost = scp.empty() ? 0 : double(lost) / double(scp.size());
    a.scp_A = statisticsOf(std::move(scp));
    a.direction_deg = statisticsOf(std::move(direction));
    return a;
  }
};

// The spheres that can touch any point within `reach` of the path.
std::vector<Sphere> spheresNear(const SphereGrid& scene, double probe_A, const Vec3* path, std::size_t count,
                                double reach) {
  Vec3 low(1e300), high(-1e300);
  for (std::size_t k = 0; k < count; ++k) low = glm::min(low, path[k]), high = glm::max(high, path[k]);
  std::vector<Sphere> out;
  scene.visitNearBox(low, high, reach + probe_A, [&](auto, const Sphere& b) {
    if (glm::distance(b.centre_A, glm::clamp(b.centre_A, low, high)) <= b.radius_A + probe_A + reach) out.push_back(b);
  });
  return out;
}

}  // namespace

double angle_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / std::numbers::pi;
}

Accuracy accuracyOf(const Method& method, const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                    const std::vector<Stroke>& strokes) {
  ExactTracker exact(scene, probe_A);
  const auto tracker = method.make(scene, probe_A);
  Errors errors;
  for (const Stroke& stroke : strokes) {
    exact.reset();
    tracker->reset();
    for (const Vec3& h : stroke.approach) exact.step({h}), tracker->step({h});
    for (const Vec3& h : stroke.counted) {
      const Contact right = exact.step({h}), c = tracker->step({h});
      if (right.touching()) errors.add(h, c, right.scp.A);
    }
  }
  return std::move(errors).result();
}

Accuracy exactAgainstOracle(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                            const std::vector<Stroke>& strokes, std::size_t piece) {
  ExactTracker exact(scene, probe_A);
  Errors errors;
  for (const Stroke& stroke : strokes) {
    const std::size_t count = std::min(piece, stroke.counted.size());
    if (count < 2) continue;
    exact.reset();
    for (const Vec3& h : stroke.approach) exact.step({h});
    Contact c = exact.step({stroke.counted[0]});
    // On these strokes the SCP lags behind the HIP by at most a few angstroms; the oracle needs all spheres between.
    oracle::Oracle oracle(spheresNear(*scene, probe_A, stroke.counted.data(), count, 3.0), probe_A);
    oracle.place(c.scp.A);
    for (std::size_t k = 1; k < count; ++k) {
      c = exact.step({stroke.counted[k]});
      const oracle::Oracle::Answer right = oracle.step(stroke.counted[k]);
      if (!right.decided)
        oracle.place(c.scp.A);
      else if (right.contact)
        errors.add(stroke.counted[k], c, right.scp_A);
    }
  }
  return std::move(errors).result();
}

}  // namespace moltact::bench
