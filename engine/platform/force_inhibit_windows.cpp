#include <windows.h>

#include <cstdlib>
#include <mutex>

#include "engine/platform/force_inhibit.h"
#include "engine/platform/force_inhibit_calls.h"

namespace moltact {
namespace {

// A crash on any thread; the system then continues as without a handler.
LONG WINAPI onCrash(EXCEPTION_POINTERS*) {
  endForce();
  return EXCEPTION_CONTINUE_SEARCH;
}

}  // namespace

// The system's clock sleeps in milliseconds.
void platform::rest_ns(std::int64_t time) noexcept { Sleep(DWORD((time + 999'999) / 1'000'000)); }

std::int64_t platform::now_ns() noexcept { return std::int64_t(GetTickCount64()) * 1'000'000; }

void platform::catchEndings() noexcept {
  static std::once_flag once;
  try {
    std::call_once(once, [] {
      SetUnhandledExceptionFilter(onCrash);
      std::atexit([] { endForce(); });
    });
  } catch (...) {  // without a lock
  }
}

// A HID device of Windows is not a file that accepts reports unchanged, so the device's own watchdog ends the force.
LastReport::~LastReport() = default;
bool LastReport::arm(const char*, std::span<const std::uint8_t>) noexcept { return false; }

// The system reports a stack overflow like other crashes.
CrashStack::CrashStack() noexcept = default;
CrashStack::~CrashStack() = default;

}  // namespace moltact
