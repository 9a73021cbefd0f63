// Distributes independent tasks over all processors. A task may write only its own data, so the results do not depend
// on the number of threads. Never for work that is timed.
#pragma once

#include <cstddef>
#include <functional>

namespace moltact::bench {

/// Calls work(0) … work(count - 1) in no fixed order, and occasionally `done(number of finished tasks)` on the calling
/// thread. An exception of a task is rethrown at the end.
void inManyThreads(std::size_t count, const std::function<void(std::size_t)>& work,
                   const std::function<void(std::size_t)>& done = {});

}  // namespace moltact::bench
