// Does independent pieces of work on every processor. A piece may write only its own data; then the results are the
// same for any number of threads. Never for work that is timed.
#pragma once

#include <cstddef>
#include <functional>

namespace moltact::bench {

/// Calls work(0) … work(count - 1), in no fixed order, and `done(how many)` now and then on the calling thread. An
/// exception of any piece is rethrown at the end.
void inManyThreads(std::size_t count, const std::function<void(std::size_t)>& work,
                   const std::function<void(std::size_t)>& done = {});

}  // namespace moltact::bench
