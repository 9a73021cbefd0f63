#include <windows.h>

#include "engine/platform/realtime.h"

namespace moltact {
namespace {

// Converts ticks of the performance counter, seconds and rest separately, to avoid overflow.
std::int64_t nanoseconds(LONGLONG ticks, LONGLONG per_s) noexcept {
  constexpr std::int64_t kPer_s = 1'000'000'000;
  return ticks / per_s * kPer_s + ticks % per_s * kPer_s / per_s;
}

LONGLONG frequency() noexcept {
  static const LONGLONG per_s = [] {
    LARGE_INTEGER f{};
    QueryPerformanceFrequency(&f);
    return f.QuadPart;
  }();
  return per_s;
}

// One timer per sleeping thread; of high resolution from Windows 10 1803 on, otherwise of the system's clock.
HANDLE timerOfThisThread() noexcept {
  struct Timer {
    HANDLE handle =
        CreateWaitableTimerExW(nullptr, nullptr, 0x2 /* CREATE_WAITABLE_TIMER_HIGH_RESOLUTION */, TIMER_ALL_ACCESS);
    Timer() {
      if (!handle) handle = CreateWaitableTimerW(nullptr, TRUE, nullptr);
    }
    ~Timer() {
      if (handle) CloseHandle(handle);
    }
  };
  thread_local const Timer timer;
  return timer.handle;
}

}  // namespace

RealtimeStatus becomeRealtime() noexcept {
  (void)timerOfThisThread();
  return SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_TIME_CRITICAL) ? RealtimeStatus::Realtime
                                                                              : RealtimeStatus::Ordinary;
}

std::int64_t monotonic_ns() noexcept {
  LARGE_INTEGER now{};
  QueryPerformanceCounter(&now);
  return nanoseconds(now.QuadPart, frequency());
}

void sleepUntil(std::int64_t due_ns) noexcept {
  constexpr std::int64_t kUnit_ns = 100;
  for (std::int64_t left_ns = due_ns - monotonic_ns(); left_ns > 0; left_ns = due_ns - monotonic_ns()) {
    HANDLE const timer = timerOfThisThread();
    LARGE_INTEGER relative{};
    relative.QuadPart = -((left_ns + kUnit_ns - 1) / kUnit_ns);
    if (timer && SetWaitableTimer(timer, &relative, 0, nullptr, nullptr, FALSE))
      WaitForSingleObject(timer, INFINITE);
    else
      Sleep(1);
  }
}

}  // namespace moltact
