#include "engine/device/device_model.h"

#include <algorithm>
#include <cmath>

namespace moltact {

namespace {

// Shortened to a limit; zero if it is not finite.
Vec3 shortened(const Vec3& wanted, double most) {
  const double size = glm::length(wanted);
  if (!std::isfinite(size)) return Vec3(0.0);
  return size > most ? wanted * (most / size) : wanted;
}

Quat exponential(const Vec3& turn) {
  const double angle = glm::length(turn);
  return angle > 0.0 ? glm::angleAxis(angle, turn / angle) : kNoRotation;
}

// The rate of a rotation vector u whose exponential turns with the angular velocity w, to second order in u.
Vec3 rateOf(const Vec3& u, const Vec3& w) {
  const Vec3 uw = glm::cross(u, w);
  return w - 0.5 * uw + glm::cross(u, uw) / 12.0;
}

}  // namespace

DeviceModel::DeviceModel(const DeviceParameters& device, const HandParameters& hand, PointMm at,
                         const Quat& orientation)
    : device_(device), hand_(hand), x_(1e-3 * at.mm), target_(1e-3 * at.mm), q_(orientation), wrist_(orientation) {
  queue_.resize(static_cast<std::size_t>(std::clamp(device.delay_ticks, 0, 100)));
}

PointMm DeviceModel::sensed() const {
  const double step = device_.resolution_mm;
  const Vec3 mm = 1e3 * x_;
  return {step > 0 ? glm::floor(mm / step + 0.5) * step : mm};
}

Vec3 DeviceModel::acceleration(const Vec3& x, const Vec3& v, const Vec3& target, const Vec3& target_v) const {
  Vec3 force = held_ - device_.damping_N_s_per_m * v + hand_.stiffness_N_per_m * (target - x) +
               hand_.damping_N_s_per_m * (target_v - v);
  const double speed = glm::length(v);
  if (speed > 0 && device_.friction_N > 0)
    force -= v * (device_.friction_N * std::tanh(speed / device_.friction_speed_m_per_s) / speed);
  return force / device_.mass_kg;
}

Vec3 DeviceModel::angularAcceleration(const Quat& q, const Vec3& w, const Quat& wrist, const Vec3& wrist_w) const {
  const Vec3 torque = held_turn_ - 1e-3 * device_.rotational_damping_N_mm_s * w +
                      1e-3 * hand_.turn_stiffness_N_mm * rotationBetween(q, wrist) +
                      1e-3 * hand_.turn_damping_N_mm_s * (wrist_w - w);
  return torque / device_.inertia_kg_m2;
}

void DeviceModel::tick(const Wrench& command, PointMm target, const Quat& orientation) {
  Command now{shortened(command.force.N, device_.max_force_N),
              shortened(1e-3 * command.torque_N_mm, 1e-3 * device_.max_torque_N_mm)};
  if (!queue_.empty()) {
    std::swap(now, queue_[next_]);
    next_ = (next_ + 1) % queue_.size();
  }
  held_ = now.force;
  held_turn_ = now.torque;
  moveOn(1e-3 * target.mm);
  turnOn(orientation);
}

void DeviceModel::moveOn(const Vec3& to) {
  const Vec3 from = target_, target_v = (to - from) / device_.tick_s;
  const double dt = device_.tick_s / device_.substeps;
  for (int k = 0; k < device_.substeps; ++k) {
    const auto hand = [&](double part) { return from + target_v * ((k + part) * dt); };
    const Vec3 a1 = acceleration(x_, v_, hand(0), target_v);
    const Vec3 v2 = v_ + a1 * (dt / 2), a2 = acceleration(x_ + v_ * (dt / 2), v2, hand(0.5), target_v);
    const Vec3 v3 = v_ + a2 * (dt / 2), a3 = acceleration(x_ + v2 * (dt / 2), v3, hand(0.5), target_v);
    const Vec3 v4 = v_ + a3 * dt, a4 = acceleration(x_ + v3 * dt, v4, hand(1), target_v);
    x_ += (v_ + 2.0 * v2 + 2.0 * v3 + v4) * (dt / 6);
    v_ += (a1 + 2.0 * a2 + 2.0 * a3 + a4) * (dt / 6);
  }
  target_ = to;
}

void DeviceModel::turnOn(const Quat& to) {
  const Quat from = wrist_;
  if (to == from && q_ == from && w_ == Vec3(0.0) && held_turn_ == Vec3(0.0)) return;  // at rest
  const Vec3 wrist_w = rotationBetween(from, to) / device_.tick_s;
  const double dt = device_.tick_s / device_.substeps;
  for (int k = 0; k < device_.substeps; ++k) {
    const auto wrist = [&](double part) { return exponential(wrist_w * ((k + part) * dt)) * from; };
    const auto turned = [&](const Vec3& by) { return exponential(by) * q_; };
    const Vec3 a1 = angularAcceleration(q_, w_, wrist(0), wrist_w);
    const Vec3 u2 = w_ * (dt / 2), w2 = w_ + a1 * (dt / 2);
    const Vec3 r2 = rateOf(u2, w2), a2 = angularAcceleration(turned(u2), w2, wrist(0.5), wrist_w);
    const Vec3 u3 = r2 * (dt / 2), w3 = w_ + a2 * (dt / 2);
    const Vec3 r3 = rateOf(u3, w3), a3 = angularAcceleration(turned(u3), w3, wrist(0.5), wrist_w);
    const Vec3 u4 = r3 * dt, w4 = w_ + a3 * dt;
    const Vec3 r4 = rateOf(u4, w4), a4 = angularAcceleration(turned(u4), w4, wrist(1), wrist_w);
    q_ = glm::normalize(turned((w_ + 2.0 * r2 + 2.0 * r3 + r4) * (dt / 6)));
    w_ += (a1 + 2.0 * a2 + 2.0 * a3 + a4) * (dt / 6);
  }
  wrist_ = to;
}

}  // namespace moltact
