// Work in background threads: their limits, and waiting for them.
#include "engine/platform/background.h"

#include <doctest/doctest.h>
#include <signal.h>

#include <future>

using namespace moltact;

TEST_CASE("a thread of background work has a signal stack of its own, so that a stack overflow in it ends the force") {
  auto has_stack = inBackground([] {
    stack_t now{};
    return sigaltstack(nullptr, &now) == 0 && !(now.ss_flags & SS_DISABLE) && now.ss_size >= 16 * 1024;
  });
  CHECK(has_stack.get());
}

TEST_CASE("work that is replaced or dropped while it runs is not awaited, and its result is discarded") {
  NewestWork<int> newest;
  std::promise<void> gate;
  const std::shared_future<void> open = gate.get_future().share();
  newest.begin(inBackground([open] { return open.wait(), 1; }));
  CHECK(newest.busy());
  CHECK_FALSE(newest.take());
  newest.begin(inBackground([open] { return open.wait(), 2; }));
  newest.drop();  // would stand here until the gate opens, which only this thread does
  CHECK_FALSE(newest.busy());
  newest.begin(inBackground([] { return 3; }));
  CHECK(newest.wait() == 3);
  CHECK_FALSE(newest.wait());
  gate.set_value();
}
