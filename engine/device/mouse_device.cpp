#include "engine/device/mouse_device.h"

#include <algorithm>
#include <limits>

#include "engine/language/catalogue.h"

namespace moltact {

MouseDevice::MouseDevice() {
  info_.name = N_("Mouse");
  info_.workspace_mm = Vec3(std::numeric_limits<double>::infinity());  // the hand is put where it is wanted
}

void MouseDevice::lead(PointMm target) noexcept {
  if (!finite(target.mm)) return;
  sent_.target = target;
  lead_.write(sent_);
}

void MouseDevice::place(PointMm target) noexcept {
  ++sent_.discontinuities;
  lead(target);
}

DevicePose MouseDevice::read(double dt_s) noexcept {
  const Lead& lead = lead_.read();
  if (lead.discontinuities != placed_) {
    placed_ = pose_.discontinuities = lead.discontinuities;
    pose_.position = lead.target;
    return pose_;
  }
  Vec3 way = (lead.target.mm - pose_.position.mm) * (1.0 - std::exp(-dt_s / kGlide_s));
  const double length = glm::length(way), most = kFastest_mm_per_s * dt_s;
  if (length > most) way *= most / length;
  pose_.position.mm += way;
  return pose_;
}

}  // namespace moltact
