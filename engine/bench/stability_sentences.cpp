#include "engine/bench/stability.h"
namespace moltact::bench {
std::string stabilitySentences(const std::vector<StabilityResult>&, const StabilityLimits&) { return {}; }
}
