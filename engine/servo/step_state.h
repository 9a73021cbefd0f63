// The state of a servo step as text, a line a value: its name and its number to the last bit. What a file holds becomes
// a state value by value, by its name and within its range, so that no text gives a step that the loop could not be in.
// Not for the haptic thread. Units: those of the members that are named.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// "heat.heat_N2=1.8p+3", …: every value that the next tick depends on but the tracker, in hexadecimal.
std::string stateText(const ServoStep& step);

/// The step that `text` describes. A Problem (its message alone) where a name is missing, twice there or not known, and
/// where a value is no number or out of its range.
Expected<ServoStep> stepFromText(std::string_view text);

}  // namespace moltact
