// Does independent pieces of work on every processor. What a piece writes must be its own; the results are
// then the same however many threads there are. Never for what is timed.
#pragma once

#include <cstddef>
#include <functional>

namespace moltact::bench {

/// Calls work(0) … work(count - 1), in no order, and `done(how many)` now and then on the calling thread. An
/// exception of any piece is thrown again at the end.
void inManyThreads(std::size_t count, const std::function<void(std::size_t)>& work,
                   const std::function<void(std::size_t)>& done = {});

}  // namespace moltact::bench
