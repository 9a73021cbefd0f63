#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <time.h>

#include "engine/platform/realtime.h"

namespace moltact {

RealtimeStatus becomeRealtime() noexcept {
  // Page faults cost more than a tick; without the permission to lock memory the loop still runs.
  (void)mlockall(MCL_CURRENT);
  sched_param priority{};
  priority.sched_priority = 80;  // above the window and the disk, below the kernel's own watchdogs
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) == 0 ? RealtimeStatus::Realtime
                                                                           : RealtimeStatus::Ordinary;
}

std::int64_t monotonic_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

void sleepUntil(std::int64_t due_ns) noexcept {
  const timespec due{due_ns / 1'000'000'000, due_ns % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) != 0) {
  }
}

}  // namespace moltact
