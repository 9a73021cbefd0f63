#include "app/ui/scene/force_control.h"

#include <memory>

#include "engine/servo/plain_trackers.h"

namespace moltact {
namespace {

constexpr double kTrialSpring_N_per_mm = 0.2;

}  // namespace

ServoSettings trialSettings(const ServoSettings& of_scene) {
  ServoSettings out = of_scene;
  out.force_on = true;
  out.workspace = Workspace();
  out.stiffness_N_per_mm = kTrialSpring_N_per_mm;
  out.clutch = ClutchSettings();
  return out;
}

void ForceControl::stop(bool stopped) {
  felt_.settings.panic = stopped;
  if (stopped) endTrial();
  felt_.passSettings();
}

bool ForceControl::tryOut(double force_N) {
  if (felt_.played || felt_.settings.panic) return false;
  felt_.servo.loop().setSettings(trialSettings(felt_.settings));
  felt_.servo.tryInteraction(
      std::make_unique<ConstantForceTracker>(force_N / kTrialSpring_N_per_mm * Workspace().A_per_mm));
  return true;
}

void ForceControl::endTrial() {
  if (!trying()) return;
  ++felt_.settings.discontinuities;
  felt_.servo.loop().setSettings(felt_.settingsOfScene());
  felt_.servo.setInteraction(felt_.freshInteraction());
}

void ForceControl::startSoftly() {
  felt_.log.clear();
  ++felt_.settings.discontinuities;
  felt_.servo.beginAgain(felt_.settingsNow());
}

}  // namespace moltact
