#include <unistd.h>

#include "engine/platform/terminal.h"

namespace moltact {

bool standardErrorIsTerminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace moltact
