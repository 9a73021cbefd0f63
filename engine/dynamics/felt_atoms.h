// How the atoms of a simulation are felt, and how the hand's force reaches them: the constants of the loop that the window
// closes (app/ui/extensions/live_molecule.h), for its tests and its benchmark too.
#pragma once

#include <cmath>

namespace moltact {

/// The felt atoms follow the simulated ones with this time constant, so that the hand feels their thermal motion smoothed.
inline constexpr double kFeltSmoothing_s = 0.04;
/// The hand's impulses are summed for this time, and a motion of the felt atoms takes as long: less than a frame of the
/// screen at 60 frames a second.
inline constexpr int kFeltStep_ticks = 16;
inline constexpr double kFeltStep_s = 0.001 * kFeltStep_ticks;

/// The part of the distance to the simulated atoms that the felt ones move in `dt_s`.
inline double feltShare(double dt_s) { return 1.0 - std::exp(-dt_s / kFeltSmoothing_s); }

}  // namespace moltact
