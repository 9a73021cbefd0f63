#include "engine/haptics/penalty/penalty_tracker.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"

namespace moltact {
PenaltyTracker::PenaltyTracker(std::shared_ptr<const SphereGrid> scene, double probe_A) : nearby_(std::move(scene)) {
  nearby_.setProbe(usableProbe_A(probe_A, kWaterProbe_A));
}

void PenaltyTracker::reset() noexcept {
  has_been_outside_ = false;
  free_gap_ = 0.0;
}

void PenaltyTracker::setProbe(double probe_A) noexcept {
  nearby_.setProbe(usableProbe_A(probe_A, nearby_.probe_A()));
  free_gap_ = 0.0;
}

bool PenaltyTracker::setMotion(const SphereMotion* motion) noexcept {
  if (nearby_.has(motion)) return true;
  nearby_.setMotion(motion);
  free_gap_ = 0.0;
  return true;
}

void PenaltyTracker::advanceTo(double fraction) noexcept {
  if (fraction == nearby_.fraction()) return;
  nearby_.advanceTo(fraction);
  free_gap_ = 0.0;
}

MemoryUsage PenaltyTracker::memoryUsage() const noexcept { return {0, sizeof(*this) + nearby_.scene().bytes()}; }

Contact PenaltyTracker::step(PointA hip) noexcept {
  if (!usableHip(hip.A)) return refusedHip(hip, last_);
  last_ = hip.A;
  squares_ = products_ = Vec3(0.0);
  const Vec3 h = hip.A - nearby_.origin(), moved = h - free_from_;
  if (glm::dot(moved, moved) < free_gap_ * free_gap_) return {.scp = hip};

  struct Push {
    double depth;
    std::int32_t sphere;
    Vec3 outward;
  };
  Push deepest[3];  // the three largest pushes, in descending order
  Vec3 sum(0.0), squares(0.0), products(0.0);
  double energy_A2 = 0.0;
  int count = 0;
  nearby_.each(h, 0.0, [&](const NearSphere& b) {
    const Vec3 m = h - b.centre;
    const double d2 = glm::dot(m, m);
    if (d2 >= b.radius * b.radius) return;
    const double d = std::sqrt(d2);
    const Vec3 n = d > 0.0 ? m / d : Vec3(0.0);
    const double depth = b.radius - d;
    sum += n * depth;
    squares += n * n;
    products += Vec3(n.y * n.z, n.z * n.x, n.x * n.y);
    energy_A2 += 0.5 * depth * depth;
    int at = std::min(count, 3);
    for (; at > 0 && depth > deepest[at - 1].depth; --at)
      if (at < 3) deepest[at] = deepest[at - 1];
    if (at < 3) deepest[at] = {depth, b.index, n};
    ++count;
  });
  if (count == 0) {
    has_been_outside_ = true;
    free_from_ = h;
    free_gap_ = nearby_.clearanceAt(h);
    return {.scp = hip};
  }
  if (!has_been_outside_) return {.scp = hip, .fault = Fault::StartedInside};
  squares_ = squares;
  products_ = products;
  last_ = hip.A + sum;
  Contact out{
      .scp = {last_}, .feature = Feature(std::min(count, 3)), .displacement_A = last_ - hip.A, .energy_A2 = energy_A2};
  for (int k = 0; k < std::min(count, 3); ++k) {
    int at = k;
    for (; at > 0 && out.atoms[at - 1] > deepest[k].sphere; --at) {
      out.atoms[at] = out.atoms[at - 1];
      out.normals[at] = out.normals[at - 1];
    }
    out.atoms[at] = deepest[k].sphere;
    out.normals[at] = deepest[k].outward;
  }
  return out;
}

Response PenaltyTracker::respond(const PoseA& pose) noexcept {
  Response out{.contact = step(pose.place)};
  if (out.contact.touching()) out.stiffness_factor = stiffestDirection();
  return out;
}

// The largest eigenvalue of the sum of n n^T over the pushes' directions, by Smith's closed form (1961). Along the
// radius a sphere's spring has its full stiffness. Across it, the push only increases outward, which is no stiffness.
double PenaltyTracker::stiffestDirection() const noexcept {
  const double mean = (squares_.x + squares_.y + squares_.z) / 3.0;
  const Vec3 d = squares_ - mean;
  const double p = std::sqrt((glm::dot(d, d) + 2.0 * glm::dot(products_, products_)) / 6.0);
  if (!(p > 0.0)) return std::max(1.0, mean);
  const Vec3 a = d / p, b = products_ / p;
  const double half_determinant =
      0.5 * (a.x * a.y * a.z + 2.0 * b.x * b.y * b.z - a.x * b.x * b.x - a.y * b.y * b.y - a.z * b.z * b.z);
  return std::max(1.0, mean + 2.0 * p * std::cos(std::acos(std::clamp(half_determinant, -1.0, 1.0)) / 3.0));
}

}  // namespace moltact
