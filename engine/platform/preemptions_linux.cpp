#include <sys/resource.h>

#include "engine/platform/preemptions.h"

namespace moltact {

std::uint64_t preemptionsOfThisThread() {
  rusage usage{};
  return ::getrusage(RUSAGE_THREAD, &usage) == 0 ? static_cast<std::uint64_t>(usage.ru_nivcsw) : 0;
}

}  // namespace moltact
