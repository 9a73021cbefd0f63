#include "engine/platform/preemptions.h"

namespace moltact {

// Windows counts none of a thread's.
std::uint64_t preemptionsOfThisThread() { return 0; }

}  // namespace moltact
