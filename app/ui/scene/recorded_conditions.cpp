#include "app/ui/scene/recorded_conditions.h"

#include "engine/haptics/touch_setup.h"

namespace moltact {
namespace {

constexpr double kSameView_rad = 1e-9;  // a recorded view within this of the present one is the same

void takeTouch(const ServoSettings& from, ServoSettings& settings) {
  TouchSetup touch;
  from.giveTo(touch);
  touch.force_on = settings.force_on;
  settings.take(touch);
}

}  // namespace

bool RecordedConditions::lead(const ServoSettings& recorded, ServoSettings& settings, Camera& camera) {
  if (!on()) before_ = settings;
  const bool anew = !on() || now_->discontinuities != recorded.discontinuities;
  // A view that differs by rounding only stays as it is.
  const Quat felt = glm::normalize(glm::quat_cast(recorded.workspace.rotation));
  if ((anew || now_->workspace.rotation != recorded.workspace.rotation) &&
      glm::length(rotationBetween(camera.orientation, felt)) > kSameView_rad)
    camera.orientation = felt;
  takeTouch(recorded, settings);
  settings.workspace = recorded.workspace;
  settings.clutch = recorded.clutch;
  now_ = recorded;
  return anew;
}

bool RecordedConditions::end(ServoSettings& settings) {
  if (!on()) return false;
  takeTouch(*before_, settings);
  now_.reset();
  return true;
}

}  // namespace moltact
