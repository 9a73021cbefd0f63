// Work that the window does not wait for: on a thread of its own, or at once where no thread can be had (a page in a
// browser; a system that gives no more of them). Window's thread.
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

/// Whether this program may begin threads at all.
bool threadsCanBeHad() noexcept;

/// As std::async, on a thread that ends the force even where it dies of a stack overflow, as a hostile file may make
/// it. The future is ready when this returns where there was no thread.
template <class Work, class... Arguments>
auto inBackground(Work work, Arguments... arguments) -> std::future<std::invoke_result_t<Work, Arguments...>> {
  if (threadsCanBeHad()) {
    try {
      return std::async(
          std::launch::async,
          [work](Arguments... given) mutable {
            const CrashStack crash_stack;
            return work(std::move(given)...);
          },
          arguments...);
    } catch (const std::system_error&) {  // no further thread
    }
  }
  auto done = std::async(std::launch::deferred, std::move(work), std::move(arguments)...);
  done.wait();
  return done;
}

/// The newest of several pieces of such work. One that a newer one replaces, or that is dropped, goes on to its end and
/// is not waited for, but by the destructor.
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
  /// Whether take() would give a result.
  bool done() const { return wanted_.valid() && ready(wanted_); }
  /// The result once it is there, given once.
  std::optional<Result> take() {
    if (!wanted_.valid() || !ready(wanted_)) return std::nullopt;
    return wanted_.get();
  }
  /// The same, waiting for it.
  std::optional<Result> wait() {
    if (!wanted_.valid()) return std::nullopt;
    return wanted_.get();
  }

 private:
  static bool ready(const std::future<Result>& f) {
    return f.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  std::future<Result> wanted_;
  std::vector<std::future<Result>> unwanted_;  // a future waits in its destructor, so they end on their own first
};

}  // namespace moltact
