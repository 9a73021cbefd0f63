// A second interaction that follows the servo loop's, for judging a method by the exact one. Any thread that owns the
// interaction.
#pragma once

#include "engine/haptics/interaction.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// Gives `reference` the state in which the loop's interaction responded in this tick, in the order of ServoStep::tick:
/// first the surface changes and moves, then the hand. `motion` is that of the tick, null for spheres at rest. The
/// caller then calls respond({tick.hip, tick.orientation}).
inline void followTick(Interaction& reference, const ServoSample& tick, const SphereMotion* motion) noexcept {
  if (tick.contact_reset) reference.reset();
  if (tick.probe_A != reference.probe_A()) reference.setProbe(tick.probe_A);
  reference.setSurface(tick.surface);
  reference.setMotion(motion);
  if (motion) reference.advanceTo(tick.fraction);
}

}  // namespace moltact
