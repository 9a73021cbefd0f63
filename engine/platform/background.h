// Work that the window does not wait for: on a thread of its own, or at once where no thread can be had (a page in a
// browser; a system that gives no more of them). Window's thread.
#pragma once

#include <future>
#include <system_error>
#include <utility>

namespace moltact {

/// Whether this program may begin threads at all.
bool threadsCanBeHad() noexcept;

/// As std::async; the future is ready when this returns where there was no thread.
template <class Work, class... Arguments>
auto inBackground(Work work, Arguments... arguments) -> std::future<std::invoke_result_t<Work, Arguments...>> {
  if (threadsCanBeHad()) {
    try {
      return std::async(std::launch::async, work, arguments...);
    } catch (const std::system_error&) {  // no further thread
    }
  }
  auto done = std::async(std::launch::deferred, std::move(work), std::move(arguments)...);
  done.wait();
  return done;
}

}  // namespace moltact
