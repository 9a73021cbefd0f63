// The state of a servo step as text, one value per line: name and exact number. stepFromText() checks the name and
// range of each value, so that no text produces a state that the loop cannot reach. Not for the haptic thread. Units:
// those of the named members.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// All values that the next tick depends on, except the interaction, in hexadecimal: "heat.heat_N2=1.8p+3", …
std::string stateText(const ServoStep& step);

/// Parses the state described by `text`. Returns a Problem (message only) if a name is missing, repeated or unknown, or
/// if a value is not a number or out of range.
Expected<ServoStep> stepFromText(std::string_view text);

}  // namespace moltact
