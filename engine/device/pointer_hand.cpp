#include "engine/device/pointer_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/haptics/sweep.h"

namespace moltact {

namespace {

constexpr double kGlide_s = 0.04;  // time constant of a hovering hand toward the pointer

// The overloads in this scope would hide it.
using moltact::finite;
bool finite(const glm::dvec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
bool finite(const ViewRays& r) {
  return finite(r.eye_A) && finite(r.forward) && finite(r.right) && finite(r.up) && std::isfinite(r.tan_half_fov) &&
         std::isfinite(r.width_px) && r.width_px > 0 && std::isfinite(r.height_px) && r.height_px > 0;
}
bool finite(const PointerInput& in) {
  return std::isfinite(in.dt_s) && std::isfinite(in.force_N) && std::isfinite(in.push_notches) &&
         std::isfinite(in.N_per_A) && finite(in.pull_N) && std::isfinite(in.well_N_A) &&
         std::isfinite(in.pull_N_per_A) && finite(in.keys) && finite(in.hip.A) && finite(in.rays) &&
         (!in.pointer_px || finite(*in.pointer_px));
}

// True if the hand is in a noticeable well.
bool wellLeads(const PointerInput& in) {
  return in.press && in.field && in.well_N_A < 0.0 &&
         glm::length(in.pull_N) + in.pull_N_per_A * PointerHand::kWellReach_A >= PointerHand::kWell_N;
}

// 1 in free space, less under force.
double pace(const PointerInput& in) { return 1.0 / (1.0 + std::max(0.0, in.force_N) / PointerHand::kHalfPace_N); }

// A distance from the eye beyond the whole scene.
double farBehind_A(const ViewRays& rays, const SphereGrid& scene, const HandShape& held) {
  return glm::distance(rays.eye_A, 0.5 * (scene.low_A() + scene.high_A())) +
         glm::distance(scene.low_A(), scene.high_A()) + 2.0 * held.reach_A() + 1.0;
}

}  // namespace

void PointerHand::reset() { *this = PointerHand(); }

void PointerHand::waitAt(const PointA& place) {
  hip_ = place;
  waits_ = true;
}

PointA PointerHand::lead(const PointerInput& in, const SphereGrid& scene, const HandShape& held) {
  if (!finite(in) || !std::isfinite(held.probe_A) || !rotates(held.orientation)) return hip_;
  const double dt = std::clamp(in.dt_s, 0.0, 0.1);
  const ViewRays& rays = in.rays;

  if (!placed_) {
    aim_ = in.pointer_px.value_or(glm::dvec2(0.5 * rays.width_px, 0.5 * rays.height_px));
    last_pointer_ = aim_;
    const Vec3 middle = 0.5 * (scene.low_A() + scene.high_A());
    plane_depth_ = glm::dot(middle - rays.eye_A, rays.forward);
    depth_ = -kHover_A;
    placed_ = true;
  }

  if (waits_) {
    if (!in.press) return hip_;
    waits_ = false;
    pressing_ = true;
    over_A_ = hip_.A;
    if (in.pointer_px) last_pointer_ = *in.pointer_px;
  }
  in_well_ = pressing_ && wellLeads(in);
  if (in_well_) {
    followWell(in, dt);
    return meetSurface(in, scene, held);
  }
  // The view may have been magnified meanwhile; a pressed surface keeps its position.
  if (pressing_) plane_depth_ = glm::dot(over_A_ - rays.eye_A, rays.forward);
  const bool stands = in.press || in.pointer_px == last_pointer_;
  aim(in, dt);
  const Vec3 along = rays.direction(aim_);
  sink(in, dt * (depth_ < 0.0 ? 2.0 : pace(in)) * kPressSpeed_A_per_s, in.field ? -glm::dot(in.pull_N, along) : 0.0);
  const double far = farBehind_A(rays, scene, held);
  const Hit hit = sweep(scene, held, rays.eye_A, rays.eye_A + along * far);
  const double forward = std::max(0.1, glm::dot(along, rays.forward));
  const double before = plane_depth_ / forward;
  double distance = before, under = -kHover_A;
  met_ = hit.sphere >= 0;
  // A press slides over one surface. Past the rim it continues into free space, not onto a surface far behind; a
  // surface far in front hides the present one.
  const bool falls = met_ && pressing_ && hit.t * far - before > kLeap_A;
  leapt_ = met_ && pressing_ && before - hit.t * far > kLeap_A;
  if (leapt_ || falls) depth_ = -kHover_A;
  if (met_) {
    distance = falls ? before + kFall_A_per_s * dt : hit.t * far;
    under = depth_;
    plane_depth_ = distance * forward;
  }
  over_A_ = rays.eye_A + along * distance;
  if (met_ && stands) stood_A_ = over_A_;
  hip_ = {over_A_ + along * under};
  return hip_;
}

// Moves down the energy by a fraction of the remaining distance. The stiffness bounds the distance to the point without
// force, so that the hand does not pass it. The target stays near the hand, which glides after it.
void PointerHand::followWell(const PointerInput& in, double dt_s) {
  constexpr double kLag_A = 0.5;
  const ViewRays& rays = in.rays;
  const double pull_N = glm::length(in.pull_N), longest_A = kMaxWellStep_A * 60.0 * dt_s;
  if (pull_N > 0.0) {
    const double left_A = pull_N / std::max(in.pull_N_per_A, 1e-9);
    hip_.A += in.pull_N * (std::min(left_A * std::min(1.0, dt_s / kSettle_s), longest_A) / pull_N);
  }
  const double depth_A = std::max(0.1, glm::dot(hip_.A - rays.eye_A, rays.forward));
  const double A_per_px = 2.0 * rays.tan_half_fov * depth_A / rays.height_px;
  glm::dvec2 carried_px(0.0);
  if (in.pointer_px) carried_px = *in.pointer_px - std::exchange(last_pointer_, *in.pointer_px);
  carried_px += glm::dvec2(in.keys.x, -in.keys.y) * (0.12 * rays.height_px * dt_s * pace(in));
  const Vec3 away = rays.forward * (in.push_notches * kMaxNotch_A);
  const Vec3 carried = (rays.right * carried_px.x - rays.up * carried_px.y) * A_per_px + away;
  const double max_A = kMaxSpeed_A_per_s * dt_s, distance_A = glm::length(carried);
  hip_.A += distance_A > max_A ? carried * (max_A / distance_A) : carried;
  if (const Vec3 ahead = hip_.A - in.hip.A; glm::length(ahead) > kLag_A)
    hip_.A = in.hip.A + ahead * (kLag_A / glm::length(ahead));
}

// After a motion in a well, a press continues from the hand's position when the well no longer acts.
PointA PointerHand::meetSurface(const PointerInput& in, const SphereGrid& scene, const HandShape& held) {
  const ViewRays& rays = in.rays;
  if (glm::dot(hip_.A - rays.eye_A, rays.forward) > 0.1) aim_ = rays.pixel(hip_.A);
  const Vec3 along = rays.direction(aim_);
  const double far = farBehind_A(rays, scene, held), distance_A = glm::distance(rays.eye_A, hip_.A);
  const Hit hit = sweep(scene, held, rays.eye_A, rays.eye_A + along * far);
  met_ = hit.sphere >= 0;
  leapt_ = false;
  depth_ = met_ ? distance_A - hit.t * far : -kHover_A;
  over_A_ = hip_.A - along * depth_;
  plane_depth_ = glm::dot(over_A_ - rays.eye_A, rays.forward);
  return hip_;
}

// Motion across the line of sight: to the pointer, or by the keys. A hand that still touches after a release is first
// lifted.
void PointerHand::aim(const PointerInput& in, double dt_s) {
  const ViewRays& rays = in.rays;
  if (pressing_ && !in.press && in.touching) {
    lift_left_s_ = kLift_s;
    if (glm::dot(in.hip.A - rays.eye_A, rays.forward) > 0.0) aim_ = rays.pixel(in.hip.A);
  }
  lift_left_s_ = in.touching && !in.press ? lift_left_s_ - dt_s : 0.0;
  const bool lifting = lift_left_s_ > 0.0;
  if (in.pointer_px && !lifting) {
    if (aim_follows_ || *in.pointer_px != last_pointer_) {
      const glm::dvec2 offset = *in.pointer_px - aim_;
      const double far_px = glm::length(offset),
                   px_per_A = rays.height_px / (2.0 * rays.tan_half_fov * std::max(0.1, plane_depth_));
      double part = 1.0 - std::exp(-dt_s / kGlide_s);
      if (in.press) part = far_px > 0.0 ? std::min(1.0, kMaxSpeed_A_per_s * dt_s * px_per_A / far_px) : 1.0;
      aim_ += offset * part;
      aim_follows_ = true;
    }
    last_pointer_ = *in.pointer_px;
  }
  if (in.over_control && aim_follows_ && !in.press && !lifting && stood_A_ &&
      glm::dot(*stood_A_ - rays.eye_A, rays.forward) > 0.1)
    aim_ += (rays.pixel(*stood_A_) - aim_) * (1.0 - std::exp(-dt_s / kGlide_s));
  if (in.keys != glm::dvec2(0.0)) {
    const double speed_px = 0.12 * rays.height_px * dt_s * (pressing_ ? pace(in) : 1.0);
    aim_ += glm::dvec2(in.keys.x, -in.keys.y) * speed_px;
    aim_follows_ = false;  // the keys control the aim until the pointer moves again
  }
  aim_ = glm::clamp(aim_, glm::dvec2(0.0), glm::dvec2(rays.width_px, rays.height_px));
}

// Motion along the line of sight: a press sinks with time, more slowly at a larger force, until it rests; notches act
// at once. In a field it also stops, or retreats, where the opposing force exceeds that of the press.
void PointerHand::sink(const PointerInput& in, double distance_A, double opposing_N) {
  if (!in.press) {
    depth_ = -kHover_A;
    goal_N_ = kRest_N;
  } else {
    const double N_per_A = std::max(in.N_per_A, kNotch_N / kMaxNotch_A), max_press_N = kMaxDepth_A * N_per_A;
    const double before_N = goal_N_;
    goal_N_ = std::clamp(goal_N_ + in.push_notches * kNotch_N, kMinPress_N, std::max(kRest_N, max_press_N));
    const double goal_A = std::min(goal_N_ / N_per_A, kMaxDepth_A);
    const double sunk_A = depth_ + distance_A + std::max(0.0, (goal_N_ - before_N) / N_per_A);
    if (opposing_N > goal_N_)
      depth_ -= std::min((opposing_N - goal_N_) / std::max(in.pull_N_per_A, 1e-9) * 0.2, kMaxWellStep_A);
    else
      depth_ = std::min(goal_A, sunk_A);
  }
  pressing_ = in.press;
}

}  // namespace moltact
