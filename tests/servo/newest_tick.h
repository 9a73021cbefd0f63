// The newest tick of a servo loop, taken from the ticks that the loop returns to its owner. For the owner's thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

#include "engine/servo/servo_loop.h"

namespace moltact::test {

class NewestTick {
 public:
  explicit NewestTick(ServoLoop& loop) : loop_(loop) {}

  /// Drains the loop and returns its last tick. Valid until the next call.
  const ServoSample& operator()() {
    loop_.drain([this](const ServoSample& sample) { newest_ = sample; });
    return newest_;
  }
  /// Waits until a thread has ticked the loop `ticks` times more.
  void wait(std::uint64_t ticks) {
    const std::uint64_t until = (*this)().tick + ticks;
    while ((*this)().tick < until) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

 private:
  ServoLoop& loop_;
  ServoSample newest_;
};

}  // namespace moltact::test
