// Rate control: a deflection sets the speed of the hand, as for a SpaceMouse's cap and a game pad's sticks. Pure
// functions. Units: millimetre, radian, second; deflections are -1 to 1 (+x right, +y up, +z toward the user).
#pragma once

#include <algorithm>

#include "engine/device/device.h"

namespace moltact::rate_control {

inline constexpr double kDead = 0.05;               ///< dead zone: a smaller deflection counts as rest
inline constexpr double kMaxSpeed_mm_per_s = 60.0;  ///< speed of the hand at full deflection
inline constexpr double kMaxSpeed_rad_per_s = 1.5;  ///< its angular speed at full deflection
inline constexpr double kReach_mm = 80.0;           ///< largest distance from the middle on any axis
/// Without a report for this time a deflection counts as released: the report was lost.
inline constexpr double kSilence_s = 0.25;

/// The deflection with squared length, so that a light push is slow; zero within kDead.
inline Vec3 shaped(const Vec3& push) noexcept {
  const double size = glm::length(push);
  if (!(size > kDead)) return Vec3(0.0);
  const double part = std::min(1.0, (size - kDead) / (1.0 - kDead));
  return push * (part * part / size);
}

/// Moves the hand during `dt_s`.
inline void move(DevicePose& pose, const Vec3& push, double dt_s) noexcept {
  const Vec3 place = pose.position.mm + shaped(push) * (kMaxSpeed_mm_per_s * dt_s);
  pose.position.mm = glm::clamp(place, Vec3(-kReach_mm), Vec3(kReach_mm));
}

/// Rotates the hand about the device's axes during `dt_s`.
inline void rotate(DevicePose& pose, const Vec3& rotation, double dt_s) noexcept {
  const Vec3 angle_rad = shaped(rotation) * (kMaxSpeed_rad_per_s * dt_s);
  if (const double size = glm::length(angle_rad); size > 0.0)
    pose.orientation = glm::normalize(glm::angleAxis(size, angle_rad / size) * pose.orientation);
}

}  // namespace moltact::rate_control
