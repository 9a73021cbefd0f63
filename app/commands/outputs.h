// Checks a command's output files. An output must not be a file that the command reads, and two outputs must not be the
// same file. file_guard.h enforces this at every write; long commands call checkOutputs() before they begin.
#pragma once

#include <vector>

#include "engine/platform/file_guard.h"

namespace moltact {

/// Throws CommandError if an output must not be written. Call it after all inputs have been read and before the first
/// output is written.
void checkOutputs(const std::vector<NamedOutput>& outputs);

}  // namespace moltact
