// `moltact device record` and `moltact device replay`: record a hand on a molecule, and check that a recording
// reproduces its forces.
#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// Adds both commands to `moltact device`.
void addDeviceRecording(CLI::App& device);

}  // namespace moltact
