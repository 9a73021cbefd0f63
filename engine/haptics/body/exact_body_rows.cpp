// Gaps, energy and curvature of the exact body at a pose (docs/exact-body.md). Part of ExactBody; haptic thread.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/haptics/body/exact_body.h"

namespace moltact {
namespace {

constexpr double kMinPivot = 1e-3, kMinModified = 0.02;
constexpr double kAugmentation = 20.0;

Vec3 cross(const Vec3& a, const Vec3& b) { return glm::cross(a, b); }

}  // namespace

// Sets the rows, one for each near pair: its gap, and the gap's derivative in the scaled coordinates.
void ExactBody::lookAround() noexcept {
  if (rows_known_) return;
  rows_known_ = true;
  metric_known_ = false;
  pairs_.look(pose_);
  const std::span<const BodyPair> near = pairs_.near();
  row_count_ = near.size();
  std::int32_t sphere = -1;
  Vec3 lever(0.0), centre(0.0);
  for (std::size_t k = 0; k < row_count_; ++k) {
    const BodyPair& pair = near[k];
    if (pair.sphere != sphere) {
      sphere = pair.sphere;
      lever = pose_.axes * pairs_.spheres()[std::size_t(sphere)].centre_A;
      centre = pose_.place + lever;
    }
    const Vec3 m = centre - pair.centre;
    const double distance = std::sqrt(glm::dot(m, m));
    const Vec3 normal = distance > 0.0 ? m / distance : Vec3(0, 0, 1);
    levers_[k] = lever;
    normals_[k] = normal;
    distances_[k] = std::max(distance, 1e-12);
    gaps_[k] = distance - pair.radii;
    rows_[k] = Six(normal, cross(lever, normal) / lever_);
  }
  // The contacts whose pair is no longer near end.
  int kept = 0;
  for (int h = 0; h < held_count_; ++h) {
    Held held = held_[std::size_t(h)];
    held.row = -1;
    for (std::size_t k = 0; k < row_count_ && held.row < 0; ++k)
      if (near[k].sphere == held.sphere && near[k].atom == held.atom) held.row = int(k);
    if (held.row >= 0) held_[std::size_t(kept++)] = held;
  }
  held_count_ = kept;
  room_ = pairs_.covered_A(pose_);
  if (row_count_ == 0) room_ = std::max(room_, pairs_.clearance_A(pose_));
}

// The negative gradient of E / k.
Six ExactBody::pull() const noexcept {
  return {hand_.place - pose_.place, lever_ * rotationBetween(pose_.orientation, hand_.orientation)};
}

double ExactBody::energyAt(const BodyPose& pose) const noexcept {
  const Vec3 d = hand_.place - pose.place, theta = rotationBetween(pose.orientation, hand_.orientation);
  return 0.5 * (glm::dot(d, d) + lever_ * lever_ * glm::dot(theta, theta));
}

BodyPose ExactBody::moved(const Six& step, double part) const noexcept {
  const Vec3 w = step.rotation() * (part / lever_);
  const double angle = glm::length(w);
  const Quat turn = angle > 0.0 ? Quat(std::cos(0.5 * angle), w * (std::sin(0.5 * angle) / angle)) : kNoRotation;
  return {pose_.place + step.translation() * part, turn * pose_.orientation};
}

// Upper bound of the motion of any sphere's centre in a step.
double ExactBody::motion_A(const Six& step) const noexcept {
  return glm::length(step.translation()) + glm::length(step.rotation()) / lever_ * pairs_.reach_A();
}

// Solves the program of a step. The bounds allow for the second-order term of a rotation by up to `rotation_rad`, so that
// the whole path of the step is free.
QpSolution ExactBody::solve(const Factor6* metric, const Six& pull, double rotation_rad) noexcept {
  const double half = 0.5 * rotation_rad * rotation_rad;
  for (std::size_t k = 0; k < row_count_; ++k) {
    const double arm = glm::length(levers_[k]);
    const double sink = half * (0.5 * (arm + glm::dot(normals_[k], levers_[k])) + rotation_rad * arm / 3.0);
    bounds_[k] = sink - std::max(0.0, gaps_[k] - kSkin_A);
  }
  std::array<int, 6> preferred{};
  for (int k = 0; k < held_count_; ++k) preferred[std::size_t(k)] = held_[std::size_t(k)].row;
  const QpSolution out = qp_.solve(metric, pull, {rows_.data(), row_count_}, {bounds_.data(), row_count_},
                                   {preferred.data(), std::size_t(held_count_)});
  changes_ += 1 + out.changes;
  return out;
}

// The Hessian of the Lagrangian: of E / k minus the multipliers times that of each gap. Lower triangle.
Matrix6 ExactBody::hessian(const Vec3& theta) const noexcept {
  Matrix6 out;
  for (std::size_t i = 0; i < 3; ++i) out.row[i][i] = 1.0;
  const double angle = glm::length(theta);
  const double f = angle < 1e-4 ? 1.0 - angle * angle / 12.0 : 0.5 * angle / std::tan(0.5 * angle);
  const Vec3 u = angle > 0.0 ? theta / angle : Vec3(0.0);
  const double per_L = 1.0 / lever_, per_L2 = per_L * per_L;
  glm::dmat3 turn(angle > 0.0 ? f : 1.0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) turn[i][j] += angle > 0.0 ? (1.0 - f) * u[i] * u[j] : 0.0;
  double shift = 0.0;
  Vec3 arm(0.0);
  for (int k = 0; k < held_count_; ++k) {
    const Held& held = held_[std::size_t(k)];
    const auto r = std::size_t(held.row);
    const Vec3 &a = levers_[r], &n = normals_[r];
    const double by = held.lambda / distances_[r], na = glm::dot(n, a);
    shift += by;
    arm += by * a;
    const double aa = by * glm::dot(a, a);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        turn[i][j] += per_L2 * (by * a[i] * a[j] - 0.5 * held.lambda * (n[i] * a[j] + n[j] * a[i]));
      turn[i][i] += per_L2 * (held.lambda * na - aa);
    }
    out.addOuter(by, rows_[r]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    out.row[i][i] -= shift;
    for (std::size_t j = 0; j <= i; ++j) out.row[3 + i][3 + j] += turn[int(i)][int(j)];
  }
  // The coupling -J^T J / D has the block -[a]x / L at rotation row, translation column.
  arm *= per_L;
  out.row[3][1] += arm.z, out.row[3][2] -= arm.y;
  out.row[4][0] -= arm.z, out.row[4][2] += arm.x;
  out.row[5][0] += arm.y, out.row[5][1] -= arm.x;
  return out;
}

// Factors the Hessian plus the held rows' outer products. The latter change nothing at the solution, but make the matrix
// positive definite where the Hessian is so on the null space of the rows.
void ExactBody::lookAtMetric(const Six& pull) noexcept {
  if (metric_known_) return;
  metric_known_ = true;
  Matrix6 b = hessian(pull.rotation() / lever_);
  double sum = 0.0;
  for (int k = 0; k < held_count_; ++k) sum += held_[std::size_t(k)].lambda;
  for (int k = 0; k < held_count_; ++k)
    b.addOuter(kAugmentation * (1.0 + sum), rows_[std::size_t(held_[std::size_t(k)].row)]);
  metric_ = factored(b, kMinPivot, kMinModified);
}

// The least curvature of the Lagrangian along the motions that keep every contact, and its direction.
double ExactBody::smallestCurvature(const Six& pull, Six& direction) const noexcept {
  std::array<Six, 6> basis;
  std::size_t count = 0;
  const double negligible = 1e-10 * length(pull);
  const auto add = [&](Six a, double least) {
    const double size = length(a);
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t i = 0; i < count; ++i) a.add(-dot(basis[i], a), basis[i]);
    const double left = length(a);
    if (count == 6 || !(left > least * size)) return;
    a.scale(1.0 / left);
    basis[count++] = a;
  };
  for (int k = 0; k < held_count_; ++k)
    if (held_[std::size_t(k)].lambda > negligible) add(rows_[std::size_t(held_[std::size_t(k)].row)], 1e-9);
  const std::size_t held = count;
  for (std::size_t i = 0; i < 6; ++i) {
    Six unit;
    unit[i] = 1.0;
    add(unit, 0.1);
  }
  for (std::size_t i = 0; i < 6; ++i) {  // where the threshold has left one out
    Six unit;
    unit[i] = 1.0;
    add(unit, 1e-6);
  }
  const std::size_t n = count - held;
  direction = {};
  if (n == 0) return std::numeric_limits<double>::infinity();
  Matrix6 h = hessian(pull.rotation() / lever_);
  h.mirror();
  Matrix6 reduced;
  for (std::size_t j = 0; j < n; ++j) {
    Six hz;
    for (std::size_t i = 0; i < 6; ++i) hz[i] = dot(h.row[i], basis[held + j]);
    for (std::size_t i = 0; i < n; ++i) reduced.row[i][j] = dot(basis[held + i], hz);
  }
  Six along;
  const double out = smallestEigenvalue(reduced, n, along);
  for (std::size_t j = 0; j < n; ++j) direction.add(along[j], basis[held + j]);
  return out;
}

}  // namespace moltact
