#include "engine/platform/background.h"

namespace moltact {

bool threadsAvailable() noexcept { return false; }

}  // namespace moltact
