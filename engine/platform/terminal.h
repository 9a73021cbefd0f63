// Whether a person is watching. Not for the haptic thread.
#pragma once

namespace moltact {

/// True when standard error goes to a terminal and not to a file or a pipe.
bool standardErrorIsTerminal();

}  // namespace moltact
