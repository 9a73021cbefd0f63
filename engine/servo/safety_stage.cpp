#include "engine/servo/safety_stage.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

// A device's figure as far as it can be used: what is no number or negative counts as 0.
double usable(double figure) { return std::isfinite(figure) ? std::max(0.0, figure) : 0.0; }

// Ours, or what keeps clear of the device's own limit; one that is none counts as none.
double within(double ours, double of_device) {
  return of_device > 0.0 ? std::min(ours, safety::kOfOwnLimit * of_device) : ours;
}

}  // namespace

void SafetyStage::setDevice(const DeviceSpecs& device) noexcept {
  peak_N_ = usable(device.max_force_N);
  continuous_N_ = std::min(peak_N_, usable(device.continuous_force_N));
  max_stiffness_ = usable(device.max_stiffness_N_per_mm);
  max_damping_ = usable(device.max_damping_N_s_per_m);
  damping_ = usable(device.damping_N_s_per_m);
  friction_N_ = device.friction_N > 0.0 ? usable(device.friction_N) : safety::kUnknownFriction_N;
  resolution_m_ = 1e-3 * usable(device.resolution_mm);
  device_delay_s_ = usable(device.delay_s);
  closes_loop_ = device.gives_force;
  fastest_m_per_s_ = within(safety::kFastest_m_per_s, device.speed_limit_m_per_s);
  rise_N_per_s_ = within(safety::kSlew_N_per_s, device.slew_limit_N_per_s);
  // Its motors give nothing yet. The heat stays: the device may be the one that was just gone, and its motors warm.
  force_N_ = Vec3(0.0);
  stretch_mm_ = stiffness_ = 0.0;
  passivity_.restart();
  placed_ = false;
  restart();
}

bool SafetyStage::beginTick(const DevicePose& pose, const TickTime& time) noexcept {
  acted_ = LimitFlags();
  fault_ = false;
  bool forget = false;

  // A clock that stood, ran back or is no number: what the force did meanwhile is not known.
  const bool sane = time.dt_s >= 0.0 && time.dt_s <= safety::kStale_s;
  if (!sane) {
    acted_.add(Limit::LateLoop);
    fault_ = true;
    forget = time.dt_s > safety::kOff_s;
  }
  dt_s_ = sane ? std::min(time.dt_s, kTick_s) : kTick_s;
  // The delay rises at once and falls within about a second, so that the bound does not flicker.
  const double measured_s = time.delay_s + pose.age_s;
  const double delay_s = std::isfinite(measured_s) ? std::clamp(measured_s, 0.0, safety::kOff_s) : safety::kOff_s;
  delay_s_ = std::max(delay_s, delay_s_ + (delay_s - delay_s_) * std::min(1.0, dt_s_));

  const double elapsed_s = sane ? time.dt_s : safety::kStale_s;
  elapsed_s_ = elapsed_s;
  const bool known = finite(pose.position.mm);
  if (!known) acted_.add(Limit::NotFinite);
  if (!pose.connected) acted_.add(Limit::Unplugged);
  if (pose.fault) acted_.add(Limit::DeviceFault);
  fault_ = fault_ || !known || !pose.connected || pose.fault;
  heat_.told(double(pose.motor_heat));
  const double unseen_s = stale_s_ + elapsed_s;
  stale_s_ = pose.fresh && known ? 0.0 : unseen_s;
  const bool off = !pose.connected || stale_s_ >= safety::kOff_s;
  const bool back = off_ && !off;
  forget = forget || off != off_;
  fault_ = fault_ || off;
  off_ = off;

  moved_m_ = Vec3(0.0);
  if (known) {
    if (!placed_ || back || pose.discontinuities != discontinuities_) {
      speed_.restart();
    } else {
      moved_m_ = 1e-3 * (pose.position.mm - place_mm_);
      if (glm::length(moved_m_) > safety::kJump_m_per_s * std::max(kTick_s, unseen_s)) {
        acted_.add(Limit::Jump);
        fault_ = forget = true;
        moved_m_ = Vec3(0.0);
        speed_.restart();
      }
    }
    place_mm_ = pose.position.mm;
    discontinuities_ = pose.discontinuities;
    placed_ = true;
    speed_.add(1e-3 * place_mm_, elapsed_s);
  }
  if (fault_) restart();
  return forget;
}

// Colgate & Schenkel with delay, K < b / (T/2 + t_d), b the device's damping and a light hand's; for the rounding of
// the place Abbott & Okamura, K <= 2 f_c / resolution.
double SafetyStage::stiffnessBound_N_per_mm() const noexcept {
  if (!closes_loop_) return safety::kHardest_N_per_mm;
  double bound = (damping_ + safety::kLightHand_N_s_per_m) / (kTick_s / 2 + device_delay_s_ + delay_s_);
  if (resolution_m_ > 0) bound = std::min(bound, 2 * friction_N_ / resolution_m_);
  return std::min({1e-3 * safety::kStiffnessMargin * bound, max_stiffness_, safety::kHardest_N_per_mm});
}

double SafetyStage::stiffness(double asked_N_per_mm) noexcept {
  const double asked = std::isfinite(asked_N_per_mm) ? std::clamp(asked_N_per_mm, 0.0, safety::kHardest_N_per_mm) : 0.0;
  const double bound = stiffnessBound_N_per_mm();
  if (asked > bound) acted_.add(Limit::Stiffness);
  const double goal = std::min(asked, bound), most = safety::kStiffening_N_per_mm_s * dt_s_;
  // Without contact, and while no force is given, nobody feels it change.
  stiffness_ = stretch_mm_ == 0.0 || gain_ == 0.0 ? goal : stiffness_ + std::clamp(goal - stiffness_, -most, most);
  return stiffness_;
}

double SafetyStage::allowed_N(double most_N) const noexcept {
  return std::min(heat_.allowed_N(peak_N_, continuous_N_), usable(most_N));
}

// What a spring holds whose force is cut at `most_N`.
double SafetyStage::stored_J(double stretch_mm, double stiffness_N_per_mm, double most_N) const noexcept {
  const double k = 1e3 * stiffness_N_per_mm, s = 1e-3 * stretch_mm;
  if (!(k > 0.0)) return 0.0;
  return k * s <= most_N ? 0.5 * k * s * s : most_N * s - 0.5 * most_N * most_N / k;
}

// Above kSlowing of the fastest speed the part of the force that drives the hand on falls, at that speed it is nothing.
// What brakes the hand stays.
Vec3 SafetyStage::slowed(Vec3 force) noexcept {
  const Vec3 speed = speed_.m_per_s();
  const double fast = glm::length(speed);
  const double slowing = safety::kSlowing * fastest_m_per_s_;
  if (fast <= slowing) return force;
  const double driving = glm::dot(force, speed) / fast;
  if (driving <= 0.0) return force;
  acted_.add(Limit::Speed);
  const double part = std::min(1.0, (fast - slowing) / (fastest_m_per_s_ - slowing));
  return force - speed * (part * driving / fast);
}

Vec3 SafetyStage::braked(Vec3 force, const WantedForce& wanted) noexcept {
  if (!closes_loop_) return force;
  // Both stores with what holds now: a gain or a clamp that changes is no motion of the hand.
  const double most_N = allowed_N(wanted.most_N);
  const double stored = gain_ * (stored_J(wanted.stretch_mm, wanted.stiffness_N_per_mm, most_N) -
                                 stored_J(stretch_mm_, wanted.stiffness_N_per_mm, most_N));
  const double way = glm::length(moved_m_);
  // Half of the published friction, for it is not the same everywhere.
  const double taken = dt_s_ > 0 ? way * (0.5 * friction_N_ + damping_ * way / dt_s_) : 0.0;
  const auto delay = static_cast<std::size_t>(std::lround((device_delay_s_ + delay_s_) / kTick_s));
  passivity_.observe(moved_m_, stored, taken, delay);
  if (passivity_.debt_J() > safety::kEnergyCut_J) {
    acted_.add(Limit::EnergyCut);
    passivity_.restart();
    fault_ = true;
    return Vec3(0.0);
  }
  if (force == Vec3(0.0)) return force;
  const Vec3 braking = passivity_.braking_N(speed_.m_per_s(), kTick_s, max_damping_);
  if (braking != Vec3(0.0)) acted_.add(Limit::Damping);
  return force + braking;
}

Vec3 SafetyStage::slewed(const Vec3& force) noexcept {
  const Vec3 change = force - force_N_;
  // A device that bears no quick rise may still be let go of at once.
  const bool rises = glm::length(force) > glm::length(force_N_);
  const double size = glm::length(change), most = (rises ? rise_N_per_s_ : safety::kSlew_N_per_s) * dt_s_;
  if (size <= most) return force;
  acted_.add(Limit::Slew);
  return force_N_ + change * (most / size);
}

ForceN SafetyStage::output(const WantedForce& wanted) noexcept {
  heat_.add(closes_loop_ ? glm::length(force_N_) : 0.0, elapsed_s_);

  Vec3 force = wanted.force_N;
  double size = glm::length(force), stretch_mm = wanted.stretch_mm;
  if (!finite(force) || !std::isfinite(size) || !std::isfinite(stretch_mm)) {
    acted_.add(Limit::NotFinite);
    fault_ = true;
    force = Vec3(0.0);
    size = stretch_mm = 0.0;
  }

  if (const double most = allowed_N(wanted.most_N); size > most) {
    acted_.add(most < std::min(peak_N_, usable(wanted.most_N)) ? Limit::Heat : Limit::Clamp);
    force *= most / size;
  }

  if (!wanted.on || fault_)
    restart();
  else
    gain_ = std::min(1.0, gain_ + dt_s_ / safety::kSoftStart_s);
  WantedForce known = wanted;
  known.stretch_mm = stretch_mm;
  force = braked(slowed(force), known);
  // Braking is a force like any other.
  if (const double most = allowed_N(wanted.most_N), braked_size = glm::length(force); braked_size > most)
    force *= most / braked_size;

  // What follows only takes away: braking too ends where no force is to be.
  if (gain_ < 1.0 && size > 0.0) acted_.add(Limit::SoftStart);
  force *= gain_;
  if (stale_s_ > safety::kStale_s) {
    acted_.add(Limit::StalePlace);
    force *= std::max(0.0, (safety::kFaded_s - stale_s_) / (safety::kFaded_s - safety::kStale_s));
  }
  // What is not right ends at once; all other changes go along the slew.
  if (stopped_) acted_.add(Limit::Panic);
  if (stopped_ || fault_) {
    restart();
    force = Vec3(0.0);
  } else {
    force = slewed(force);
  }
  stretch_mm_ = stretch_mm;
  force_N_ = force;
  passivity_.give(force);
  return {force};
}

double steadyStiffness_N_per_mm(double asked_N_per_mm, const DeviceSpecs& device) noexcept {
  return std::min(asked_N_per_mm, SafetyStage(device).stiffnessBound_N_per_mm());
}

}  // namespace moltact
