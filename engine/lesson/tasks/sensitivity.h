// How well a person discriminates two things, from counts of answers (signal detection theory). Pure functions; any
// thread.
#pragma once

#include <string_view>

#include "engine/language/catalogue.h"

namespace moltact {

/// The name of the quantity d' of a task's first round; attempts store it in English.
inline constexpr std::string_view kFirstRoundSensitivity = N_("d' in the first round");

/// The quantile of the standard normal distribution for a probability `p`, which is clamped to 1e-12 from 0 and 1.
double normalQuantile(double p);

/// The sensitivity index d' = z(hit rate) - z(false-alarm rate) for `hits` in `signals` trials with a difference and
/// `alarms` in `noises` trials without one. The log-linear correction of Hautus (1995) adds 0.5 to each count and 1 to
/// each number of trials, so that perfect answers give a finite value.
double sensitivity(int hits, int signals, int alarms, int noises);

}  // namespace moltact
