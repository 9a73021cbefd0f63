#include "engine/bench/many_threads.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "engine/platform/background.h"

namespace moltact::bench {

void inManyThreads(std::size_t count, const std::function<void(std::size_t)>& work,
                   const std::function<void(std::size_t)>& done) {
  std::atomic<std::size_t> next{0}, finished{0};
  std::exception_ptr thrown;
  std::mutex throwing;
  const auto run = [&](bool reports) {
    for (std::size_t k; (k = next++) < count;) {
      try {
        work(k);
        ++finished;
        if (reports && done) done(finished);
      } catch (...) {
        const std::lock_guard lock(throwing);
        if (!thrown) thrown = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  if (threadsAvailable()) try {
      for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) others.emplace_back([&] { run(false); });
    } catch (const std::system_error&) {
      // The system has no further thread; the present ones do the work.
    }
  run(true);
  for (std::thread& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace moltact::bench
