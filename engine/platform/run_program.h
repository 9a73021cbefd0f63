// Runs another program. Not for the haptic thread.
#pragma once

#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

struct ProgramRun {
  int status = 0;      ///< its exit status; 128 + the number of the signal that ended it
  std::string output;  ///< what it wrote to its standard output, at most 1 MiB; standard error goes to ours
};

/// Runs `words[0]`, found by the system's search, with the other words as its arguments; no shell reads them. `quiet`
/// discards its standard error. A Problem if it cannot be started, or on a system without programs to run.
Expected<ProgramRun> runProgram(const std::vector<std::string>& words, bool quiet = false);

/// Goes on as another program, `words[0]`, with the other words as its arguments and with our standard streams. On Linux
/// it replaces this process and returns only a Problem. Elsewhere it waits for the program and returns its exit status.
Expected<int> becomeProgram(const std::vector<std::string>& words);

}  // namespace moltact
