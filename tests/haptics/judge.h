// Compares a tracker with the oracle along one HIP path: statistics of the error of its SCP and of its force's
// direction, for inexact methods. The oracle follows its own path; ticks in which it accepts two outcomes are not
// judged. Units: angstrom, degree.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/bench/oracle.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/tracker.h"

namespace moltact::test {

struct Judged {
  int ticks = 0;                        ///< decided ticks after the start outside
  int both = 0;                         ///< of these, ticks in which both touch
  int lost = 0;                         ///< ticks in which only the oracle touches, by more than `lost_from_A`
  int false_contact = 0;                ///< ticks in which only the tracker touches, by more than that
  double deepest_A = -1e300;            ///< maximum depth of the SCP in any sphere, in all ticks with contact
  std::vector<double> off_A, turn_deg;  ///< ticks in which both touch, sorted

  double off(double share) const { return at(off_A, share); }
  double turn(double share) const { return at(turn_deg, share); }

 private:
  static double at(const std::vector<double>& sorted, double share) {
    return sorted.empty() ? 0.0 : sorted[std::min(sorted.size() - 1, std::size_t(share * double(sorted.size())))];
  }
};

/// `lost_from_A`: a shallower contact may be missed without being counted.
inline Judged judge(Tracker& tracker, const scenes::Scene& scene, const scenes::Path& path, double lost_from_A = 0.05) {
  oracle::Oracle oracle(scene.spheres, scene.probe_A);
  Judged out;
  for (const Vec3& hip : path) {
    const Contact c = tracker.step({hip});
    const oracle::Oracle::Answer right = oracle.step(hip);
    if (right.started_inside || c.fault != Fault::None) continue;
    if (c.touching()) out.deepest_A = std::max(out.deepest_A, oracle::deepest(scene.spheres, scene.probe_A, c.scp.A));
    if (!right.decided) continue;
    ++out.ticks;
    const Vec3 force = c.displacement_A, true_force = right.scp_A - hip;
    const double pull = glm::length(force), true_pull = glm::length(true_force);
    out.lost += right.contact && !c.touching() && true_pull > lost_from_A;
    out.false_contact += !right.contact && c.touching() && pull > lost_from_A;
    if (!right.contact || !c.touching()) continue;
    ++out.both;
    out.off_A.push_back(glm::distance(c.scp.A, right.scp_A));
    if (pull > 0 && true_pull > 0.01)
      out.turn_deg.push_back(std::acos(std::clamp(glm::dot(force, true_force) / (pull * true_pull), -1.0, 1.0)) * 180 /
                             std::numbers::pi);
  }
  std::sort(out.off_A.begin(), out.off_A.end());
  std::sort(out.turn_deg.begin(), out.turn_deg.end());
  return out;
}

}  // namespace moltact::test
