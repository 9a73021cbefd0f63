// The state of a servo step as text, one value a line: its name and its number to the last bit. A file's content
// becomes a state value by value, by name and within range, so that no text gives a step that the loop could not be in.
// Not for the haptic thread. Units: those of the named members.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// "heat.heat_N2=1.8p+3", …: every value that the next tick depends on except the interaction, in hexadecimal.
std::string stateText(const ServoStep& step);

/// The step that `text` describes. A Problem (its message alone) where a name is missing, repeated or unknown, and
/// where a value is not a number or out of range.
Expected<ServoStep> stepFromText(std::string_view text);

}  // namespace moltact
