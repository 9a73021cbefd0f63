#include "engine/device/pointer_hand.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/sweep.h"

namespace moltact {

namespace {

// The overloads here would hide it.
using moltact::finite;
bool finite(const glm::dvec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
bool finite(const ViewRays& r) {
  return finite(r.eye_A) && finite(r.forward) && finite(r.right) && finite(r.up) && std::isfinite(r.tan_half_fov) &&
         std::isfinite(r.width_px) && r.width_px > 0 && std::isfinite(r.height_px) && r.height_px > 0;
}
bool finite(const PointerInput& in) {
  return std::isfinite(in.dt_s) && std::isfinite(in.force_N) && std::isfinite(in.push_notches) &&
         std::isfinite(in.N_per_A) && finite(in.keys) && finite(in.rays) && (!in.pointer_px || finite(*in.pointer_px));
}

}  // namespace

void PointerHand::reset() { *this = PointerHand(); }

PointA PointerHand::lead(const PointerInput& in, const BallScene& scene, double probe_A) {
  if (!finite(in) || !std::isfinite(probe_A)) return hip_;
  const double dt = std::clamp(in.dt_s, 0.0, 0.1);
  const ViewRays& rays = in.rays;
  const double yielding = 1.0 / (1.0 + std::max(0.0, in.force_N) / kHalfGain_N);  // 1 in the open, less under force

  if (!placed_) {
    aim_ = in.pointer_px.value_or(glm::dvec2(0.5 * rays.width_px, 0.5 * rays.height_px));
    last_pointer_ = aim_;
    const Vec3 middle = 0.5 * (scene.low_A() + scene.high_A());
    plane_depth_ = glm::dot(middle - rays.eye_A, rays.forward);
    depth_ = -kHover_A;
    placed_ = true;
  }

  // Sideways: in the open the aim follows the pointer; under a press it moves by the pointer's way times the gain.
  if (in.pointer_px) {
    if (pressing_ && in.press)
      aim_ += (*in.pointer_px - last_pointer_) * yielding;
    else if (aim_follows_ || *in.pointer_px != last_pointer_) {
      aim_ += (*in.pointer_px - aim_) * (1.0 - std::exp(-dt / 0.04));
      aim_follows_ = true;
    }
    last_pointer_ = *in.pointer_px;
  }
  if (in.keys != glm::dvec2(0.0)) {
    const double speed_px = 0.12 * rays.height_px * dt * (pressing_ ? yielding : 1.0);
    aim_ += glm::dvec2(in.keys.x, -in.keys.y) * speed_px;
    aim_follows_ = false;  // the keys lead until the pointer moves again
  }
  aim_ = glm::clamp(aim_, glm::dvec2(0.0), glm::dvec2(rays.width_px, rays.height_px));

  sink(in, dt * (depth_ < 0.0 ? 2.0 : yielding) * kPressSpeed_A_per_s);

  const Vec3 along = rays.direction(aim_);
  const double far = glm::distance(rays.eye_A, 0.5 * (scene.low_A() + scene.high_A())) +
                     glm::distance(scene.low_A(), scene.high_A()) + 2.0 * probe_A + 1.0;
  const Hit hit = sweep(scene, probe_A, rays.eye_A, rays.eye_A + along * far);
  const double forward = std::max(0.1, glm::dot(along, rays.forward));
  double way = plane_depth_ / forward;
  if (hit.ball >= 0) {
    way = hit.t * far;
    plane_depth_ = way * forward;
  }
  hip_ = {rays.eye_A + along * (way + (hit.ball >= 0 ? depth_ : -kHover_A))};
  return hip_;
}

// Inward: a press sinks with time, more slowly the harder the surface pushes back, until it rests; notches act at once.
void PointerHand::sink(const PointerInput& in, double way_A) {
  if (!in.press) {
    depth_ = -kHover_A;
    goal_N_ = kRest_N;
  } else {
    const double N_per_A = std::max(in.N_per_A, kNotch_N / kLongestNotch_A), deepest_N = kDeepest_A * N_per_A;
    const double before_N = goal_N_;
    goal_N_ = std::clamp(goal_N_ + in.push_notches * kNotch_N, kLightest_N, std::max(kRest_N, deepest_N));
    const double goal_A = std::min(goal_N_ / N_per_A, kDeepest_A);
    depth_ = std::min(goal_A, depth_ + way_A + std::max(0.0, (goal_N_ - before_N) / N_per_A));
  }
  pressing_ = in.press;
}

}  // namespace moltact
