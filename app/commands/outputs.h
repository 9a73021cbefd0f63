// What a command writes. No output is a file that the command reads, and no two are one file: file_guard.h holds it
// wherever a file is written; a command with much to do asks here before it begins.
#pragma once

#include <vector>

#include "engine/platform/file_guard.h"

namespace moltact {

/// Throws CommandError where one of the outputs must not be written. Call it once the inputs have been read, and before
/// the first output is written.
void checkOutputs(const std::vector<NamedOutput>& outputs);

}  // namespace moltact
