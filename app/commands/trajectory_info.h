// The output of 'moltact info' for a trajectory.
#pragma once

#include <string>

namespace moltact {

/// Prints format, atoms, frames, times and cell of the file, as text or JSON. Throws CommandError if it cannot be read.
void printTrajectoryInfo(const std::string& file, bool json);

}  // namespace moltact
