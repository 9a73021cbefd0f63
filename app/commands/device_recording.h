// `moltact device record` and `moltact device replay`: a hand on a molecule as a file, and whether it gives the same
// forces.
#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// Adds both to `moltact device`.
void addDeviceRecording(CLI::App& device);

}  // namespace moltact
