// Rate control: how far something is pushed sets the speed of the hand, as for a SpaceMouse's cap and a game pad's
// sticks. Pure. Units: millimetre, radian, second; pushes are -1 to 1 (+x right, +y up, +z toward the person).
#pragma once

#include <algorithm>

#include "engine/device/device.h"

namespace moltact::rate_control {

inline constexpr double kDead = 0.05;              ///< a smaller push counts as rest
inline constexpr double kFastest_mm_per_s = 60.0;  ///< of the hand, at a full push
inline constexpr double kFastest_rad_per_s = 1.5;  ///< of its turning, likewise
inline constexpr double kReach_mm = 80.0;          ///< the farthest from the middle on any axis
inline constexpr double kSilence_s =
    0.25;  ///< without a report for so long a push counts as released: the report was lost

/// The push with its length squared, so that a light push is slow; zero within kDead.
inline Vec3 shaped(const Vec3& push) noexcept {
  const double size = glm::length(push);
  if (!(size > kDead)) return Vec3(0.0);
  const double part = std::min(1.0, (size - kDead) / (1.0 - kDead));
  return push * (part * part / size);
}

/// Moves the hand for `dt_s`.
inline void move(DevicePose& pose, const Vec3& push, double dt_s) noexcept {
  const Vec3 place = pose.position.mm + shaped(push) * (kFastest_mm_per_s * dt_s);
  pose.position.mm = glm::clamp(place, Vec3(-kReach_mm), Vec3(kReach_mm));
}

/// Turns the hand for `dt_s` round the device's axes.
inline void rotate(DevicePose& pose, const Vec3& rotation, double dt_s) noexcept {
  const Vec3 angle_rad = shaped(rotation) * (kFastest_rad_per_s * dt_s);
  if (const double size = glm::length(angle_rad); size > 0.0)
    pose.orientation = glm::normalize(glm::angleAxis(size, angle_rad / size) * pose.orientation);
}

}  // namespace moltact::rate_control
