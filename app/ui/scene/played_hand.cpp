#include "app/ui/scene/played_hand.h"

#include <algorithm>

namespace moltact {

void PlayedHand::show(const std::optional<ServoSample>& sample) {
  const bool was = on();
  felt_.played = sample;
  if (was == on()) return;
  felt_.atoms.stop();
  felt_.log.clear();
  ++felt_.settings.discontinuities;
  felt_.servo.begin(felt_.settingsOfScene(), felt_.freshInteraction());
}

void PlayedHand::advance(double dt_s) {
  for (owed_s_ += std::min(dt_s, 0.5); owed_s_ >= kTick_s; owed_s_ -= kTick_s) felt_.log.add(*felt_.played);
}

}  // namespace moltact
