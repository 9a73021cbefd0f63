#include "engine/haptics/penalty/penalty_tracker.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

// The greatest eigenvalue of the sum of n n^T over unit vectors: how stiff springs along them are together, each of
// stiffness 1. The sum's own matrix is symmetric; the closed form is Smith's (1961).
class SpringSum {
 public:
  void add(const Vec3& n) {
    diagonal_ += n * n;
    beside_ += Vec3(n.y * n.z, n.z * n.x, n.x * n.y);
  }
  double stiffest() const {
    const double mean = (diagonal_.x + diagonal_.y + diagonal_.z) / 3.0;
    const Vec3 d = diagonal_ - mean;
    const double p = std::sqrt((glm::dot(d, d) + 2.0 * glm::dot(beside_, beside_)) / 6.0);
    if (!(p > 0.0)) return mean;
    const Vec3 a = d / p, b = beside_ / p;
    const double half_determinant =
        0.5 * (a.x * a.y * a.z + 2.0 * b.x * b.y * b.z - a.x * b.x * b.x - a.y * b.y * b.y - a.z * b.z * b.z);
    return mean + 2.0 * p * std::cos(std::acos(std::clamp(half_determinant, -1.0, 1.0)) / 3.0);
  }

 private:
  Vec3 diagonal_{0.0}, beside_{0.0};  // of the matrix; beside_.x is its entry yz
};

}  // namespace

PenaltyTracker::PenaltyTracker(std::shared_ptr<const BallScene> scene, double probe_A) : nearby_(std::move(scene)) {
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
  parallel_ = 1.0;
  const Vec3 h = hip.A - nearby_.origin(), moved = h - free_from_;
  if (glm::dot(moved, moved) < free_gap_ * free_gap_) return {.scp = hip};

  struct Push {
    double depth = 0.0;
    std::int32_t ball = -1;
    Vec3 outward{0.0};
  };
  std::array<Push, 3> most;
  Vec3 sum(0.0);
  double energy_A2 = 0.0;
  int count = 0;
  SpringSum springs;
  nearby_.each(h, 0.0, [&](const NearBall& b) {
    const Vec3 m = h - b.centre;
    const double d2 = glm::dot(m, m);
    if (d2 >= b.radius * b.radius) return;
    const double d = std::sqrt(d2);
    ++count;
    if (d > 0.0) {
      sum += m * ((b.radius - d) / d);
      springs.add(m / d);
    }
    energy_A2 += 0.5 * (b.radius - d) * (b.radius - d);
    Push push{b.radius - d, b.index, d > 0.0 ? m / d : Vec3(0.0)};
    for (Push& p : most)
      if (push.depth > p.depth) std::swap(push, p);
  });
  if (count == 0) {
    has_been_outside_ = true;
    free_from_ = h;
    free_gap_ = nearby_.clearanceAt(h);
    return {.scp = hip};
  }
  if (!has_been_outside_) return {.scp = hip, .fault = Fault::StartedInside};
  // Along a ball's radius its spring is as stiff as any; across it, it pushes outward the more, which is no stiffness.
  parallel_ = std::max(1.0, springs.stiffest());
  last_ = hip.A + sum;
  Contact out{
      .scp = {last_}, .feature = Feature(std::min(count, 3)), .displacement_A = last_ - hip.A, .energy_A2 = energy_A2};
  for (std::size_t k = 0; k < 3 && most[k].ball >= 0; ++k) {
    std::size_t at = k;
    for (; at > 0 && out.atoms[at - 1] > most[k].ball; --at) {
      out.atoms[at] = out.atoms[at - 1];
      out.normals[at] = out.normals[at - 1];
    }
    out.atoms[at] = most[k].ball;
    out.normals[at] = most[k].outward;
  }
  return out;
}

}  // namespace moltact
