#include "app/ui/extensions/extensions.h"

namespace moltact {
namespace {
constexpr float kPlayback = 88.0f, kTurn = 56.0f, kTurnAndPrediction = 136.0f;
}

float Extensions::stripHeight() const {
  if (playback.on()) return kPlayback;
  if (!turns.on()) return 0.0f;
  return turns.turns().waiting().empty() ? kTurn : kTurnAndPrediction;
}

}  // namespace moltact
