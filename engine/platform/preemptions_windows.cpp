#include "engine/platform/preemptions.h"

namespace moltact {

// Windows does not count them per thread.
std::uint64_t preemptionsOfThisThread() { return 0; }

}  // namespace moltact
