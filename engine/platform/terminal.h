// The person at the terminal: whether one is watching, and what is typed. Not for the haptic thread.
#pragma once

#include <string>

namespace moltact {

/// True when standard error goes to a terminal and not to a file or a pipe.
bool standardErrorIsTerminal();

enum class Typed {
  Nothing,  ///< yet
  Line,
  End,      ///< nothing more will come
};
/// Waits for a line on standard input, at most so long; a signal ends the wait. Reads it without the C and C++ streams.
Typed typedLine(std::string& line, int wait_ms);

}  // namespace moltact
