#include "engine/bench/feel.h"

#include <cmath>
#include <memory>
#include <optional>

#include "engine/bench/accuracy.h"
#include "engine/core/sphere_intersections.h"
#include "engine/core/units.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact::bench {
namespace {

constexpr double kDepth_A = 0.6, kStep_A = 0.02;

// One turn around a circle, after a straight approach from `outside`.
FeelPath round(std::string name, scenes::Scene scene, Vec3 centre, Vec3 u, Vec3 w, double radius, Vec3 outside) {
  FeelPath path{std::move(name), std::move(scene), {}, {}};
  const int ticks = static_cast<int>(kTwoPi * radius / kStep_A);
  const Vec3 first = centre + u * radius;
  for (int k = 0; k < 400; ++k) path.approach.push_back(outside + (first - outside) * (k / 400.0));
  for (int k = 0; k < ticks; ++k) {
    const double t = kTwoPi * k / ticks;
    path.counted.push_back(centre + (u * std::cos(t) + w * std::sin(t)) * radius);
  }
  return path;
}

}  // namespace

std::vector<FeelPath> feelPaths() {
  std::vector<FeelPath> out;
  const scenes::Scene one = scenes::oneSphere();
  const double R = one.spheres[0].radius_A + one.probe_A;
  // A plane unrelated to the axes of any mesh.
  const Vec3 u = glm::normalize(Vec3(0.8, 0.5, -0.33)), w = glm::normalize(glm::cross(u, Vec3(0.2, 0.9, 0.4)));
  out.push_back(round("one sphere", one, Vec3(0), u, w, R - kDepth_A, u * (R + 0.5)));

  const scenes::Scene bond = scenes::bond();
  const SphereCircle crease =
      *circleOf(inflated(bond.spheres[0], bond.probe_A), inflated(bond.spheres[1], bond.probe_A));
  out.push_back(round("crease", bond, crease.centre_A, Vec3(0, 1, 0), Vec3(0, 0, 1), crease.radius_A - kDepth_A,
                      crease.centre_A + Vec3(0, crease.radius_A + 0.5, 0)));

  const scenes::Scene pit = scenes::pit();
  const double p = pit.spheres[0].radius_A + pit.probe_A, side = pit.spheres[1].centre_A.x;
  const Vec3 middle(side / 2, side * std::sqrt(3.0) / 6, 0);
  const double height = std::sqrt(p * p - side * side / 3);
  // Large enough to pass from the point onto circles and spheres and back.
  out.push_back(round("pit", pit, middle + Vec3(0, 0, height - kDepth_A), Vec3(1, 0, 0), Vec3(0, 1, 0), 0.5,
                      middle + Vec3(0.5, 0, height + 1.5)));
  return out;
}

std::vector<Feel> measureFeel(const std::vector<const Method*>& methods) {
  std::vector<Feel> out;
  for (const FeelPath& path : feelPaths()) {
    const auto scene = std::make_shared<const SphereGrid>(path.scene.spheres);
    for (const Method* method : methods) {
      const auto tracker = method->make(scene, path.scene.probe_A);
      for (const Vec3& h : path.approach) tracker->step({h});
      std::vector<double> turn, change;
      std::optional<Vec3> last;
      std::size_t lost = 0;
      for (const Vec3& h : path.counted) {
        const Contact c = tracker->step({h});
        const Vec3& pull = c.displacement_A;
        if (last) {
          if (c.touching() && *last != Vec3(0)) turn.push_back(angle_deg(*last, pull));
          change.push_back(glm::distance(*last, pull));
        }
        lost += !c.touching();
        last = pull;
      }
      out.push_back({path.name, method, statisticsOf(std::move(turn)), statisticsOf(std::move(change)),
                     double(lost) / double(path.counted.size())});
    }
  }
  return out;
}

ReportTable feelTable(const std::vector<Feel>& rows) {
  ReportTable t{
      "feel",
      "Perceptible change of the force from tick to tick",
      {{"path", "path"},
       {"method", "method"},
       {"turn_p50_deg", "turn, median (deg)"},
       {"turn_p99_deg", "turn, p99 (deg)"},
       {"turn_max_deg", "turn, max (deg)"},
       {"change_p99_A", "change, p99 (A)"},
       {"change_max_A", "change, max (A)"},
       {"lost_percent", "contact lost (%)"}},
      {},
      "The step of the force is the change times the stiffness of the spring. On a true sphere the force turns "
      "uniformly."};
  for (const Feel& f : rows)
    t.rows.push_back({f.path, std::string(f.method->name), f.turn_deg.p50, f.turn_deg.p99, f.turn_deg.max,
                      f.change_A.p99, f.change_A.max, 100 * f.lost});
  return t;
}

}  // namespace moltact::bench
