// Energy that a method makes out of nothing, judged by closed paths alone: no store is assumed, so that every
// method is judged by the same law. Units: angstrom, newton, millimetre, joule.
#pragma once

#include <functional>
#include <memory>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"

namespace moltact::bench {

/// The most energy that the method gives back over a part of the path that begins and ends released: outside
/// every ball, with neither contact nor force. The work is summed by the trapezoidal rule in pieces of at most
/// kEnergyStep_A with the uncut force of the spring, so that no sampling is in it. A path that is never
/// released makes 0.
double madeAlong(Tracker& tracker, const scenes::Scene& scene, const scenes::Path& path, const LoopSettings& loop);

inline constexpr double kEnergyStep_A = 0.004;

/// The path closed outside: from its end straight up to the true surface, back over it along the way of the
/// right SCP, and so to its beginning; led once forward and once backward, for what turns round one way only
/// gains, loses the other way. The greater of both. `path` begins outside (else only what follows counts).
double madeOverClosedPath(const std::function<std::unique_ptr<Tracker>()>& make, const scenes::Scene& scene,
                          const scenes::Path& path, const LoopSettings& loop);

}  // namespace moltact::bench
