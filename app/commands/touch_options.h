// The options of the headless commands that choose what a molecule is felt with.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/haptics/touch_setup.h"

namespace moltact {

/// Adds --method and an option for all else that an interaction is made with (engine/haptics/touch_setup.h), of which
/// there is a choice. `touch` must outlive the parsing.
void addTouchOptions(CLI::App& command, TouchSetup& touch);

/// Adds --probe.
void addProbeOption(CLI::App& command, TouchSetup& touch);

}  // namespace moltact
