#include "engine/platform/preemptions.h"

namespace moltact {

std::uint64_t preemptionsOfThisThread() { return 0; }  // a browser does not tell

}  // namespace moltact
