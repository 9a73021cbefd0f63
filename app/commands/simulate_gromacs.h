#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// Adds `gromacs` to the command `simulate`.
void addSimulateGromacs(CLI::App& simulate);

}  // namespace moltact
