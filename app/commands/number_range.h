// A check for options that are numbers. CLI::Range passes NaN, since NaN compares false with both ends.
#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// Passes a finite number from `least` to `most`; anything else ends the command with status 2.
CLI::Validator numberFrom(double least, double most);

}  // namespace moltact
