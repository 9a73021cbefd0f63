// A check for numeric options. CLI::Range accepts NaN, because NaN compares false with both limits.
#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// Accepts a finite number from `min` to `max`. Anything else ends the command with exit status 2.
CLI::Validator numberFrom(double min, double max);

}  // namespace moltact
