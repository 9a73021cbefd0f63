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

/// Calls run(scene, method, draw, index) for every combination, `index` with the draw changing fastest and the scene
/// slowest, and `progress(finished fraction, a scene at work)` on the calling thread.
template <class Run, class Progress>
void inScenesAndDraws(std::size_t scenes, std::size_t methods, std::size_t draws, const Run& run,
                      const Progress& progress) {
  const std::size_t count = scenes * methods * draws;
  inManyThreads(
      count, [&](std::size_t k) { run(k / draws / methods, k / draws % methods, k % draws, k); },
      [&](std::size_t done) {
        progress(double(done) / double(count), (done < count ? done : count - 1) / draws / methods);
      });
}

}  // namespace moltact::bench
