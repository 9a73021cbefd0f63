// How well someone tells two things apart, from counts of answers (signal detection theory). Pure functions; any
// thread.
#pragma once

#include <string_view>

#include "engine/language/catalogue.h"

namespace moltact {

/// The name of the figure that holds d' of a task's first round. Attempts hold it in English.
inline constexpr std::string_view kFirstRoundSensitivity = N_("d' in the first round");

/// The z of which a standard normal value is smaller with probability p; p within 0 to 1, both excluded (else clamped
/// to 1e-12 from the ends).
double normalQuantile(double p);

/// The sensitivity index d' = z(hits) - z(false alarms) of `hits` in `signals` trials that had something to detect and
/// `alarms` in `noises` trials that had not. 0.5 is added to each count and 1 to each number of trials (the log-linear
/// correction of Hautus 1995), so that it is finite for perfect answers.
double sensitivity(int hits, int signals, int alarms, int noises);

}  // namespace moltact
