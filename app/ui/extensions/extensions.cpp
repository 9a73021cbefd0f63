#include "app/ui/extensions/extensions.h"

#include "app/ui/application/application.h"

namespace moltact {
namespace {
constexpr float kPlayback = 88.0f, kTurn = 56.0f, kTurnAndPrediction = 136.0f;
}

float Extensions::stripHeight() const {
  if (playback.on()) return kPlayback;
  if (!turns.on()) return 0.0f;
  return turns.turns().waiting().empty() ? kTurn : kTurnAndPrediction;
}

// The application knows no more than the set; every program of ours is made with these (shell/application_parts.h).
Extensions& Application::extensions() { return static_cast<Extensions&>(*extensions_); }
const Extensions& Application::extensions() const { return static_cast<const Extensions&>(*extensions_); }

}  // namespace moltact
