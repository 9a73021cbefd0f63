// The energy that a method generates, measured by closed paths alone. It assumes no storage, so it applies equally to
// all methods. Units: angstrom, newton, millimetre, joule.
#pragma once

#include <functional>
#include <memory>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_motion.h"

namespace moltact::bench {

/// The largest energy that the method returns over a part of the path that begins and ends released: outside every
/// sphere, with neither contact nor force. The work is summed per tick with the unclamped force of the spring, by the
/// trapezoidal rule, so that sampling does not contribute. If the force jumps within a tick, the smaller of both sides
/// counts. A path without release gives 0.
double madeAlong(Interaction& felt, const scenes::Scene& scene, const scenes::Path& path, const LoopSettings& loop);

/// The same for the path closed outside: from its end straight up to the true surface, along the reference SCP back to
/// its beginning. The path is run forward and backward, because a cycle that gains energy in one direction loses it in
/// the other; the larger result counts. `path` should begin outside; otherwise the part inside is ignored.
double madeOverClosedPath(const std::function<std::unique_ptr<Interaction>()>& make, const scenes::Scene& scene,
                          const scenes::Path& path, const LoopSettings& loop);

/// The same along a path over moving spheres, of which the first `phases.size()` places are one for each phase; the others
/// belong to the last phase. While the spheres move the hand stands still: what the springs store more by this is the work
/// of the surface and not generated, and what they lose by it is not regained. It needs the energy that the method states
/// (Contact::energy_A2).
double madeOverMoving(Interaction& felt, const scenes::Scene& scene, const std::vector<MotionPhase>& phases,
                      const scenes::Path& path, const LoopSettings& loop);

}  // namespace moltact::bench
