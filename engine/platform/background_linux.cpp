#include "engine/platform/background.h"

namespace moltact {

bool threadsCanBeHad() noexcept { return true; }

}  // namespace moltact
