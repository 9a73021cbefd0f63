#include "engine/bench/oracle_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact::bench {

OracleTracker::OracleTracker(std::vector<Sphere> spheres, double probe_A)
    : resting_(std::move(spheres)), spheres_(resting_), probe_A_(probe_A), oracle_(spheres_, probe_A) {}

Contact OracleTracker::step(PointA hip) noexcept {
  if (moved_) {
    oracle_ = oracle::Oracle(spheres_, probe_A_);
    if (scp_A_) oracle_.place(*scp_A_);
    moved_ = false;
  }
  const oracle::Oracle::Answer answer = oracle_.step(hip.A);
  decided_ = decided_ && answer.decided;
  Contact out;
  out.scp = hip;
  if (answer.started_inside) {
    out.fault = Fault::StartedInside;
    scp_A_.reset();
    return out;
  }
  scp_A_ = answer.scp_A;
  if (!answer.contact) return out;
  out.scp.A = answer.scp_A;
  stretchToScp(out, hip);
  // Of the spheres whose surface is at the SCP, those with the steepest normals against the spring block it.
  constexpr double kTouched_A = 1e-7;
  struct Blocking {
    double against;
    std::int32_t atom;
    Vec3 normal;
  };
  std::vector<Blocking> blocking;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const Vec3 way = out.scp.A - spheres_[i].centre_A;
    const double distance = glm::length(way), radius = spheres_[i].radius_A + probe_A_;
    if (radius <= 0.0 || std::abs(distance - radius) > kTouched_A) continue;
    blocking.push_back({glm::dot(way / distance, out.displacement_A), std::int32_t(i), way / distance});
  }
  std::stable_sort(blocking.begin(), blocking.end(),
                   [](const Blocking& a, const Blocking& b) { return a.against > b.against; });
  if (blocking.size() > 3) blocking.resize(3);
  std::sort(blocking.begin(), blocking.end(), [](const Blocking& a, const Blocking& b) { return a.atom < b.atom; });
  for (std::size_t k = 0; k < blocking.size(); ++k) {
    out.atoms[k] = blocking[k].atom;
    out.normals[k] = blocking[k].normal;
  }
  out.feature = blocking.size() == 3 ? Feature::Point : blocking.size() == 2 ? Feature::Circle : Feature::Sphere;
  return out;
}

void OracleTracker::reset() noexcept {
  oracle_.reset();
  scp_A_.reset();
}

void OracleTracker::setProbe(double probe_A) noexcept {
  probe_A_ = probe_A;
  moved_ = true;
}

bool OracleTracker::setMotion(const SphereMotion* motion) noexcept {
  motion_ = motion;
  spheres_ = motion ? motion->at(0.0) : resting_;
  moved_ = true;
  return true;
}

void OracleTracker::advanceTo(double fraction) noexcept {
  if (!motion_) return;
  spheres_ = motion_->at(fraction);
  moved_ = true;
}

bool OracleTracker::decided() noexcept { return std::exchange(decided_, true); }

void OracleTracker::place(const Vec3& scp_A) {
  oracle_.place(scp_A);
  scp_A_ = scp_A;
}

}  // namespace moltact::bench
