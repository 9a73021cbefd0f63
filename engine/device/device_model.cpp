#include "engine/device/device_model.h"

#include <algorithm>
#include <cmath>

namespace moltact {

DeviceModel::DeviceModel(const DeviceParameters& device, const HandParameters& hand, PointMm at)
    : device_(device), hand_(hand), x_(1e-3 * at.mm), target_(1e-3 * at.mm) {
  queue_.assign(static_cast<std::size_t>(std::clamp(device.delay_ticks, 0, 100)), Vec3(0.0));
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

void DeviceModel::tick(ForceN command, PointMm target) {
  Vec3 force = command.N;
  const double size = glm::length(force);
  if (!std::isfinite(size))
    force = Vec3(0.0);
  else if (size > device_.max_force_N)
    force *= device_.max_force_N / size;
  held_ = force;
  if (!queue_.empty()) {
    std::swap(held_, queue_[next_]);
    next_ = (next_ + 1) % queue_.size();
  }
  const Vec3 from = target_, to = 1e-3 * target.mm, target_v = (to - from) / device_.tick_s;
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

}  // namespace moltact
