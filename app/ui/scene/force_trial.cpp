#include "app/ui/scene/force_trial.h"

#include <memory>

#include "engine/servo/plain_trackers.h"

namespace moltact {
namespace {

constexpr double kSpring_N_per_mm = 0.2;

}  // namespace

void ForceTrial::begin(double force_N, const ServoSettings& of_scene) {
  servo_.loop().setSettings(settings(of_scene));
  servo_.tryInteraction(std::make_unique<ConstantForceTracker>(force_N / kSpring_N_per_mm * Workspace().A_per_mm));
}

ServoSettings ForceTrial::settings(const ServoSettings& of_scene) {
  ServoSettings out = of_scene;
  out.force_on = true;
  out.workspace = Workspace();
  out.stiffness_N_per_mm = kSpring_N_per_mm;
  out.clutch = ClutchSettings();
  return out;
}

}  // namespace moltact
