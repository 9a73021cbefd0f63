// Energy that a method makes from nothing, judged by closed paths alone: no store is assumed, so every method is judged
// by the same law. Units: angstrom, newton, millimetre, joule.
#pragma once

#include <functional>
#include <memory>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/tracker.h"

namespace moltact::bench {

/// The most energy that the method gives back over a part of the path that begins and ends released: outside
/// every sphere, with neither contact nor force. The work is summed tick by tick with the uncut force of the
/// spring, by the trapezoidal rule, so that no sampling is in it; where the force jumps within a tick the
/// lesser of both sides counts. A path that is never released makes 0.
double madeAlong(Tracker& tracker, const scenes::Scene& scene, const scenes::Path& path, const LoopSettings& loop);

/// The path closed outside: from its end straight up to the true surface, back over it along the way of the
/// right SCP, and so to its beginning; led once forward and once backward, for what turns round one way only
/// gains, loses the other way. The greater of both. `path` begins outside (else only what follows counts).
double madeOverClosedPath(const std::function<std::unique_ptr<Tracker>()>& make, const scenes::Scene& scene,
                          const scenes::Path& path, const LoopSettings& loop);

}  // namespace moltact::bench
