#include "app/ui/scene/played_hand.h"

#include <algorithm>

namespace moltact {

void PlayedHand::addTo(TouchLog& log, double dt_s) {
  for (owed_s_ += std::min(dt_s, 0.5); owed_s_ >= kTick_s; owed_s_ -= kTick_s) log.add(*sample_);
}

}  // namespace moltact
