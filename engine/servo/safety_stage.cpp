#include "engine/servo/safety_stage.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

// A device's figure as far as it is usable: NaN, infinite or negative counts as 0.
double usable(double figure) { return std::isfinite(figure) ? std::max(0.0, figure) : 0.0; }

// The mean of min(1, 1 / load) over an interval in which the load changes linearly, weighted with the load: the
// fraction of the energy that a clamped force returns. For a spring, whose load is proportional to the stretch, this
// closed form is exact.
double meanShare(double from, double to) {
  const double low = std::min(from, to), high = std::max(from, to);
  if (high <= 1.0) return 1.0;
  if (low >= 1.0) return 2.0 / (low + high);
  return ((1.0 - low) * (1.0 + low) + 2.0 * (high - 1.0)) / ((high - low) * (high + low));
}

// The requested value as a multiple of the limit; 0 if nothing is requested.
double loadOf(double wanted, double limit) { return wanted > 0.0 ? wanted / limit : 0.0; }

// The smaller of our limit and a margin below the device's own; an invalid limit of the device is ignored.
double within(double ours, double of_device) {
  return of_device > 0.0 ? std::min(ours, safety::kVendorLimitMargin * of_device) : ours;
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
  peak_torque_N_mm_ = device.dof_out >= 6 ? usable(device.max_torque_N_mm) : 0.0;
  rotational_damping_N_mm_s_ = usable(device.rotational_damping_N_mm_s);
  closes_loop_ = device.gives_force;
  max_speed_m_per_s_ = within(safety::kMaxSpeed_m_per_s, device.speed_limit_m_per_s);
  rise_N_per_s_ = within(safety::kSlew_N_per_s, device.slew_limit_N_per_s);
  // The new device's motors give no force yet. The heat is kept, because it may be the device that has just been
  // disconnected.
  force_N_ = torque_N_mm_ = Vec3(0.0);
  stored_ = {};
  stiffness_ = 0.0;
  field_share_ = 1.0;
  passivity_.restart();
  placed_ = false;
  restart();
}

bool SafetyStage::beginTick(const DevicePose& pose, const TickTime& time) noexcept {
  acted_ = LimitFlags();
  fault_ = false;
  bool forget = false;

  // After a stall, a step back or an invalid time, the effect of the force in the interval is unknown.
  const bool sane = time.dt_s >= 0.0 && time.dt_s <= safety::kStale_s;
  if (!sane) {
    acted_.add(Limit::LateLoop);
    fault_ = true;
    forget = time.dt_s > safety::kContactLost_s;
  }
  dt_s_ = sane ? std::min(time.dt_s, kTick_s) : kTick_s;
  // The delay estimate rises at once and decays within about a second, so that the bound does not flicker.
  const double measured_s = time.delay_s + pose.age_s;
  const double delay_s =
      std::isfinite(measured_s) ? std::clamp(measured_s, 0.0, safety::kContactLost_s) : safety::kContactLost_s;
  delay_s_ = std::max(delay_s, delay_s_ + (delay_s - delay_s_) * std::min(1.0, dt_s_));

  const double elapsed_s = sane ? time.dt_s : safety::kStale_s;
  elapsed_s_ = elapsed_s;
  const bool known = finite(pose.position.mm) && rotates(pose.orientation);
  if (!known) acted_.add(Limit::NotFinite);
  if (!pose.connected) acted_.add(Limit::Unplugged);
  if (pose.fault) acted_.add(Limit::DeviceFault);
  fault_ = fault_ || !known || !pose.connected || pose.fault;
  heat_.setReportedHeat(double(pose.motor_heat));
  const double unseen_s = stale_s_ + elapsed_s;
  stale_s_ = pose.fresh && known ? 0.0 : unseen_s;
  const bool off = !pose.connected || stale_s_ >= safety::kContactLost_s;
  const bool back = off_ && !off;
  forget = forget || off != off_;
  fault_ = fault_ || off;
  off_ = off;

  moved_m_ = rotation_rad_ = Vec3(0.0);
  if (known) {
    const auto beginAgain = [this] {
      moved_m_ = rotation_rad_ = Vec3(0.0);
      speed_.restart();
      angular_speed_.restart();
    };
    if (!placed_ || back || pose.discontinuities != discontinuities_) {
      beginAgain();
    } else {
      moved_m_ = 1e-3 * (pose.position.mm - place_mm_);
      rotation_rad_ = rotationBetween(orientation_, pose.orientation);
      const double in_s = std::max(kTick_s, unseen_s);
      if (glm::length(moved_m_) > safety::kJump_m_per_s * in_s ||
          glm::length(rotation_rad_) > safety::kJump_rad_per_s * in_s) {
        acted_.add(Limit::Jump);
        fault_ = forget = true;
        beginAgain();
      }
    }
    place_mm_ = pose.position.mm;
    orientation_ = pose.orientation;
    discontinuities_ = pose.discontinuities;
    placed_ = true;
    speed_.add(1e-3 * place_mm_, elapsed_s);
    angular_speed_.add(angle_rad_ += rotation_rad_, elapsed_s);
  }
  if (fault_) restart();
  return forget;
}

// Colgate & Schenkel with delay: K < b / (T/2 + t_d), where b is the damping of the device and a light hand. For the
// quantization of the position Abbott & Okamura: K <= 2 f_c / resolution.
double SafetyStage::stiffnessBound_N_per_mm() const noexcept {
  if (!closes_loop_) return safety::kMaxStiffness_N_per_mm;
  double bound = (damping_ + safety::kLightHand_N_s_per_m) / (kTick_s / 2 + device_delay_s_ + delay_s_);
  if (resolution_m_ > 0) bound = std::min(bound, 2 * friction_N_ / resolution_m_);
  return std::min({1e-3 * safety::kStiffnessMargin * bound, max_stiffness_, safety::kMaxStiffness_N_per_mm});
}

// The contact keeps the rest of the bound, so that its wall remains a wall in a stiff field.
double SafetyStage::maxField_N_per_mm() const noexcept { return safety::kFieldShare * stiffnessBound_N_per_mm(); }

// The stiffness at the end of the lever on which the peak force gives the peak torque. A known rotational damping b_r
// bounds it further, by the condition of Colgate & Schenkel for a rotation; the hand is counted as no damping there.
double SafetyStage::rotationalBound_N_mm() const noexcept {
  const double lever_mm = peak_N_ > 0.0 ? peak_torque_N_mm_ / peak_N_ : 0.0;
  const double bound = stiffnessBound_N_per_mm() * lever_mm * lever_mm;
  if (!closes_loop_ || rotational_damping_N_mm_s_ == 0.0) return bound;
  return std::min(bound,
                  safety::kStiffnessMargin * rotational_damping_N_mm_s_ / (kTick_s / 2 + device_delay_s_ + delay_s_));
}

// The stiffness bound of each spring with a field or a driven torque; sets the field's share.
double SafetyStage::sharedBound_N_per_mm(const LocalStiffness& felt) noexcept {
  double bound = stiffnessBound_N_per_mm();
  const double rotational = drivesTorque() ? rotationalBound_N_mm() : 0.0;
  const double limit = safety::kFieldShare * bound, max_rotational = safety::kFieldShare * rotational;
  if (!(felt.field_N_per_mm <= limit)) field_share_ = usable(limit / felt.field_N_per_mm);
  if (drivesTorque() && !(felt.field_rotational_N_mm <= max_rotational))
    field_share_ = std::min(field_share_, usable(max_rotational / felt.field_rotational_N_mm));
  if (field_share_ < 1.0) acted_.add(Limit::Stiffness);
  bound = usable((bound - field_share_ * felt.field_N_per_mm) / std::max(1.0, felt.stiffness_factor));
  if (!drivesTorque()) return bound;
  const double left = usable(rotational - field_share_ * felt.field_rotational_N_mm);
  return bound * felt.rotational_mm2 <= left ? bound : usable(left / felt.rotational_mm2);
}

double SafetyStage::stiffness(double asked_N_per_mm, const LocalStiffness& felt) noexcept {
  const double asked =
      std::isfinite(asked_N_per_mm) ? std::clamp(asked_N_per_mm, 0.0, safety::kMaxStiffness_N_per_mm) : 0.0;
  field_share_ = 1.0;
  const bool more = closes_loop_ && (felt.field || (drivesTorque() && felt.rotational_mm2 != 0.0));
  const bool shared = more || (closes_loop_ && !(felt.stiffness_factor <= 1.0));
  const double bound = more     ? sharedBound_N_per_mm(felt)
                       : shared ? usable(stiffnessBound_N_per_mm() / felt.stiffness_factor)
                                : stiffnessBound_N_per_mm();
  if (asked > bound) acted_.add(Limit::Stiffness);
  const double goal = std::min(asked, bound), limit = safety::kStiffening_N_per_mm_s * dt_s_;
  // Without contact or without force a change of the stiffness cannot be felt.
  stiffness_ =
      stored_.springs.none() || gain_ == 0.0 ? goal : stiffness_ + std::clamp(goal - stiffness_, -limit, limit);
  if (shared) stiffness_ = std::min(stiffness_, bound);
  return stiffness_;
}

double SafetyStage::allowed_N(double max_N) const noexcept {
  return std::min(heat_.allowed_N(peak_N_, continuous_N_), usable(max_N));
}

// The fraction to which a wrench is clamped: force and torque together, so that the direction is kept.
double SafetyStage::cutFraction(double force_N, double torque_N_mm, double max_N) const noexcept {
  double out = 1.0;
  if (force_N > max_N) out = max_N / force_N;
  if (drivesTorque() && torque_N_mm > peak_torque_N_mm_) out = std::min(out, peak_torque_N_mm_ / torque_N_mm);
  return out;
}

// The energy that springs return when their force is clamped to `part` of itself. Integrated over the stretch this is 2
// part - part^2 times the stored energy.
double SafetyStage::stored_J(const Springs& springs, double stiffness_N_per_mm, double max_N) const noexcept {
  const double part =
      cutFraction(stiffness_N_per_mm * springs.stretch_mm, stiffness_N_per_mm * springs.torque_mm2, max_N);
  return 1e-3 * stiffness_N_per_mm * springs.energy_mm2 * part * (2.0 - part);
}

// The increase of the stored energy between two states if a field is involved. Only the energies and forces at both
// ends are known; between them the force is assumed to change linearly. A clamped fraction of the force returns the
// same fraction of the energy.
double SafetyStage::fieldRise_J(const Stored& from, const Stored& to, double stiffness_N_per_mm,
                                double max_N) const noexcept {
  const auto load = [&](const Stored& s) {
    const double force = loadOf(s.force_N, max_N);
    return drivesTorque() ? std::max(force, loadOf(s.torque_N_mm, peak_torque_N_mm_)) : force;
  };
  const auto softened = [&](const Stored& s) { return loadOf(s.field_stiffness_N_per_mm, maxField_N_per_mm()); };
  const double springs_N_mm = stiffness_N_per_mm * (to.springs.energy_mm2 - from.springs.energy_mm2);
  const double field_N_mm = meanShare(softened(from), softened(to)) * (to.field_energy_N_mm - from.field_energy_N_mm);
  return 1e-3 * meanShare(load(from), load(to)) * (springs_N_mm + field_N_mm);
}

// From kSpeedFadeStart of the speed limit the part of the force that accelerates the hand fades; at the limit it is
// zero. A part that brakes the hand is kept.
Vec3 SafetyStage::slowed(Vec3 force) noexcept {
  const Vec3 speed = speed_.m_per_s();
  const double fast = glm::length(speed);
  const double slowing = safety::kSpeedFadeStart * max_speed_m_per_s_;
  if (fast <= slowing) return force;
  const double driving = glm::dot(force, speed) / fast;
  if (driving <= 0.0) return force;
  acted_.add(Limit::Speed);
  const double part = std::min(1.0, (fast - slowing) / (max_speed_m_per_s_ - slowing));
  return force - speed * (part * driving / fast);
}

// The same for torque and rotation.
Vec3 SafetyStage::slowedTorque(Vec3 torque) noexcept {
  const Vec3 speed = angular_speed_.m_per_s();
  const double fast = glm::length(speed), slowing = safety::kSpeedFadeStart * safety::kMaxSpeed_rad_per_s;
  const double driving = fast > slowing ? glm::dot(torque, speed) / fast : 0.0;
  if (driving <= 0.0) return torque;
  acted_.add(Limit::Speed);
  const double part = std::min(1.0, (fast - slowing) / (safety::kMaxSpeed_rad_per_s - slowing));
  return torque - speed * (part * driving / fast);
}

Vec3 SafetyStage::brakedTorque(Vec3 torque) noexcept {
  if (!closes_loop_ || torque == Vec3(0.0)) return torque;
  // Damping at the end of the lever on which the peak force gives the peak torque.
  const double lever_mm = peak_N_ > 0.0 ? peak_torque_N_mm_ / peak_N_ : 0.0;
  const Vec3 braking =
      passivity_.braking_N_mm(angular_speed_.m_per_s(), kTick_s, 1e-3 * max_damping_ * lever_mm * lever_mm);
  if (braking != Vec3(0.0)) acted_.add(Limit::Damping);
  torque += braking;
  const double size = glm::length(torque);
  return size > peak_torque_N_mm_ ? torque * (peak_torque_N_mm_ / size) : torque;
}

Vec3 SafetyStage::braked(Vec3 force, const Vec3& torque, const WantedWrench& wanted, bool begins) noexcept {
  if (!closes_loop_) return force;
  // Both energies use the present gain, limit and stiffness: their change, and that of the surface, is not a motion of
  // the hand.
  const double max_N = allowed_N(wanted.max_N);
  const Stored &from = wanted.before ? *wanted.before : stored_, &to = wanted.stored;
  double stored = 0.0;
  if (from.field || to.field) {
    // The zero of a field's energy is arbitrary, so there is no increase in the tick in which the force begins.
    if (!begins) stored = gain_ * fieldRise_J(from, to, wanted.stiffness_N_per_mm, max_N);
  } else if (!fault_) {
    stored = gain_ * (stored_J(to.springs, wanted.stiffness_N_per_mm, max_N) -
                      stored_J(from.springs, wanted.stiffness_N_per_mm, max_N));
  }
  // A torque that the device does not give is still accounted for, because the wrist rotates freely.
  if (!drivesTorque()) stored += gain_ * 0.5e-3 * glm::dot(torque_N_mm_ + torque, rotation_rad_);
  const double distance_m = glm::length(moved_m_);
  // Half of the published friction, because friction varies over the workspace.
  const double taken = dt_s_ > 0 ? distance_m * (0.5 * friction_N_ + damping_ * distance_m / dt_s_) : 0.0;
  const auto delay = static_cast<std::size_t>(std::lround((device_delay_s_ + delay_s_) / kTick_s));
  passivity_.observe(moved_m_, rotation_rad_, stored, taken, delay);
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

// Moves from the last output toward the new one, limited by the rates (per second).
Vec3 SafetyStage::slewed(const Vec3& from, const Vec3& to, double rise, double fall) noexcept {
  const Vec3 change = to - from;
  // The release may be immediate even for a device with a limited rise.
  const bool rises = glm::length(to) > glm::length(from);
  const double size = glm::length(change), limit = (rises ? rise : fall) * dt_s_;
  if (size <= limit) return to;
  acted_.add(Limit::Slew);
  return from + change * (limit / size);
}

Wrench SafetyStage::output(const WantedWrench& wanted) noexcept {
  heat_.add(closes_loop_ ? glm::length(force_N_) : 0.0, elapsed_s_);

  Vec3 force = wanted.force_N, torque = wanted.torque_N_mm;
  double size = glm::length(force), twist = glm::length(torque);
  bool sound = true;
  if (!finite(force) || !std::isfinite(size) || !finite(torque) || !std::isfinite(twist) || !wanted.stored.finite() ||
      (wanted.before && !wanted.before->finite())) {
    acted_.add(Limit::NotFinite);
    fault_ = true;
    force = torque = Vec3(0.0);
    size = twist = 0.0;
    sound = false;
  }

  const double max_N = allowed_N(wanted.max_N);
  if (const double part = cutFraction(size, twist, max_N); part < 1.0) {
    const bool warm = size > max_N && max_N < std::min(peak_N_, usable(wanted.max_N));
    acted_.add(warm ? Limit::Heat : Limit::Clamp);
    force *= part;
    torque *= part;
  }

  const bool begins = gain_ == 0.0 || fault_;
  if (!wanted.on || fault_)
    restart();
  else
    gain_ = std::min(1.0, gain_ + dt_s_ / safety::kSoftStart_s);
  force = braked(slowed(force), torque, wanted, begins);
  const Vec3 wrist_N_mm = torque;  // the requested torque, for a device without torque
  torque = drivesTorque() && !fault_ ? brakedTorque(slowedTorque(torque)) : Vec3(0.0);
  // The limit includes the braking force.
  if (const double limit = allowed_N(wanted.max_N), braked_size = glm::length(force); braked_size > limit)
    force *= limit / braked_size;

  // The following stages only reduce the force, including the braking force.
  if (gain_ < 1.0 && (size > 0.0 || twist > 0.0)) acted_.add(Limit::SoftStart);
  force *= gain_;
  torque *= gain_;
  if (stale_s_ > safety::kStale_s) {
    acted_.add(Limit::StalePlace);
    const double part = std::max(0.0, (safety::kFaded_s - stale_s_) / (safety::kFaded_s - safety::kStale_s));
    force *= part;
    torque *= part;
  }
  // After a fault, a stop or while disconnected the force ends at once; all other changes follow the slew limit.
  if (stopped_) acted_.add(Limit::Panic);
  if (stopped_ || fault_) {
    restart();
    force = torque = Vec3(0.0);
  } else {
    force = slewed(force_N_, force, rise_N_per_s_, safety::kSlew_N_per_s);
    // As fast as the force, each relative to its peak.
    const double N_mm_per_N = peak_N_ > 0.0 ? peak_torque_N_mm_ / peak_N_ : 0.0;
    if (drivesTorque())
      torque = slewed(torque_N_mm_, torque, N_mm_per_N * rise_N_per_s_, N_mm_per_N * safety::kSlew_N_per_s);
  }
  if (sound)
    stored_ = wanted.stored;
  else
    stored_ = {};
  force_N_ = force;
  torque_N_mm_ = drivesTorque() ? torque : wrist_N_mm;
  passivity_.give(force, torque);
  return {{force}, torque};
}

double springLever_A(double gyration_A, double A_per_mm, double asked_N_per_mm, const DeviceSpecs& device) noexcept {
  const double bound = SafetyStage(device).rotationalBound_N_mm(),
               stiffness = steadyStiffness_N_per_mm(asked_N_per_mm, device);
  if (!(bound > 0.0) || !(stiffness > 0.0)) return gyration_A;
  return std::min(gyration_A, A_per_mm * std::sqrt(bound / stiffness));
}

double steadyStiffness_N_per_mm(double asked_N_per_mm, const DeviceSpecs& device) noexcept {
  return std::min(asked_N_per_mm, SafetyStage(device).stiffnessBound_N_per_mm());
}

}  // namespace moltact
