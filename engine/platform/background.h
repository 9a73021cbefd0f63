// Background work for the window: on a thread of its own, or synchronously where no thread is available (a page in a
// browser; a system that refuses another thread). Window's thread.
#pragma once

#include <algorithm>
#include <chrono>
#include <future>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/platform/force_inhibit.h"

namespace moltact {

/// True if this program may start threads.
bool threadsAvailable() noexcept;

/// Like std::async, on a thread that ends all force even if it dies of a stack overflow, which a hostile file may
/// cause. Without a thread the work runs synchronously, and the returned future is ready. An exception of the work is
/// rethrown by get(), NewestWork::take() and NewestWork::wait().
template <class Work, class... Arguments>
auto inBackground(Work work, Arguments... arguments) -> std::future<std::invoke_result_t<Work, Arguments...>> {
  if (threadsAvailable()) {
    try {
      return std::async(
          std::launch::async,
          [work](Arguments... given) mutable {
            const CrashStack crash_stack;
            return work(std::move(given)...);
          },
          arguments...);
    } catch (const std::system_error&) {  // no further thread available
    }
  }
  auto done = std::async(std::launch::deferred, std::move(work), std::move(arguments)...);
  done.wait();
  return done;
}

/// The newest of several background tasks. A task that is replaced or dropped runs to its end; only the destructor
/// waits for it.
template <class Result>
class NewestWork {
 public:
  void begin(std::future<Result> work) {
    drop();
    wanted_ = std::move(work);
  }
  void drop() {
    if (wanted_.valid()) unwanted_.push_back(std::move(wanted_));
    std::erase_if(unwanted_, ready);
  }
  bool busy() const { return wanted_.valid(); }
  /// True if take() would return a result.
  bool done() const { return wanted_.valid() && ready(wanted_); }
  /// Returns the result once, when it is ready.
  std::optional<Result> take() {
    if (!wanted_.valid() || !ready(wanted_)) return std::nullopt;
    return wanted_.get();
  }
  /// Like take(), but blocks until the result is ready.
  std::optional<Result> wait() {
    if (!wanted_.valid()) return std::nullopt;
    return wanted_.get();
  }

 private:
  static bool ready(const std::future<Result>& f) {
    return f.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  std::future<Result> wanted_;
  std::vector<std::future<Result>> unwanted_;  // kept because the destructor of a future blocks
};

}  // namespace moltact
