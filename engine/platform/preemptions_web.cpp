#include "engine/platform/preemptions.h"

namespace moltact {

std::uint64_t preemptionsOfThisThread() { return 0; }  // unknown in a browser

}  // namespace moltact
