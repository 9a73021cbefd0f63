#include "engine/device/mouse_device.h"

#include <algorithm>
#include <limits>

#include "engine/language/catalogue.h"

namespace moltact {

MouseDevice::MouseDevice() {
  info_.name = N_("Mouse");
  info_.workspace_mm = Vec3(std::numeric_limits<double>::infinity());  // the hand can be placed anywhere
}

void MouseDevice::lead(PointMm target) noexcept {
  if (!finite(target.mm)) return;
  sent_.target = target;
  lead_.write(sent_);
}

void MouseDevice::place(PointMm target) noexcept {
  if (!finite(target.mm)) return;
  ++sent_.discontinuities;
  sent_.placed = target;
  lead(target);
}

void MouseDevice::turn(const Quat& orientation) noexcept {
  if (!rotates(orientation)) return;
  sent_.orientation = glm::normalize(orientation);
  lead_.write(sent_);
}

DevicePose MouseDevice::read(double dt_s) noexcept {
  const Lead& lead = lead_.read();
  if (lead.discontinuities != placed_) {
    placed_ = pose_.discontinuities = lead.discontinuities;
    pose_.position = lead.placed;
    pose_.orientation = lead.orientation;
    return pose_;
  }
  const double part = 1.0 - std::exp(-dt_s / kGlide_s);
  const Vec3 angle = rotationBetween(pose_.orientation, lead.orientation);
  if (const double size = glm::length(angle); size > 0.0)
    pose_.orientation = glm::normalize(glm::angleAxis(std::min(size * part, kMaxSpeed_rad_per_s * dt_s), angle / size) *
                                       pose_.orientation);
  Vec3 motion = (lead.target.mm - pose_.position.mm) * part;
  const double length = glm::length(motion), limit = kMaxSpeed_mm_per_s * dt_s;
  if (length > limit) motion *= limit / length;
  pose_.position.mm += motion;
  return pose_;
}

}  // namespace moltact
