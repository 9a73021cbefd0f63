#include "app/ui/scene/felt_scene.h"

#include <utility>

#include "app/ui/scene/force_control.h"
#include "engine/haptics/guide/guide_layer.h"
#include "engine/haptics/height_field/height_field_tracker.h"
#include "engine/haptics/pull_spring.h"

namespace moltact {

TouchSetup FeltScene::touch() const {
  TouchSetup out = built_setup;
  settings.giveTo(out);
  return out;
}

ServoSettings FeltScene::settingsOfScene() const {
  ServoSettings out = settings;
  out.force_on = out.force_on && !resting && !played;
  return out;
}

ServoSettings FeltScene::settingsNow() const { return servo.trying() ? trialSettings(settings) : settingsOfScene(); }

std::unique_ptr<Interaction> FeltScene::interactionAt(const Contact& contact, const PoseA& hand) {
  std::shared_ptr<const PairField> pairs;
  std::unique_ptr<Interaction> made = moltact::interactionAt(stage(), touch(), contact, hand, servo.device(), &pairs);
  forces.begin(stage(), std::move(pairs));
  if (made && scanned) return std::make_unique<HeightFieldTracker>(scanned);
  if (made && !pulled.empty())
    return std::make_unique<PullSpring>(std::move(made), pulled, stage().spheres->spheres(), pulled_masses);
  if (made && guide) return std::make_unique<GuideLayer>(std::move(made), guide->felt(guide_A_per_mm));
  return made;
}

std::unique_ptr<Interaction> FeltScene::freshInteraction() {
  if (!played) return interactionAt(Contact{}, PoseA{});
  forces.begin(stage(), nullptr);
  return nullptr;
}

void FeltScene::letGo() {
  pulled.clear();
  guide.reset();
  scanned.reset();
  scanned_like.reset();
  controls.drag(false);
}

}  // namespace moltact
