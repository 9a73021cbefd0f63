// Options of the headless commands that choose how a molecule is felt.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/haptics/touch_setup.h"

namespace moltact {

/// Adds --method, an option for every other choice that requires a new interaction (engine/haptics/touch_setup.h), and
/// those of friction.
/// `touch` must outlive the parsing. Returns the option --hand.
const CLI::Option* addTouchOptions(CLI::App& command, TouchSetup& touch);

/// Throws a CommandError if `touch` names a body's interaction but the hand holds no body, or if --hand was written with
/// another interaction and the hand holds one. `hand` is the option --hand.
void checkHand(const TouchSetup& touch, bool body, const CLI::Option* hand);

/// Adds --probe.
void addProbeOption(CLI::App& command, TouchSetup& touch);

}  // namespace moltact
