#include <windows.h>

#include <atomic>

#include "engine/platform/force_inhibit.h"
#include "engine/platform/interrupt.h"

namespace moltact {
namespace {

std::atomic<bool> wished{false};

// On a thread of the system. The first request is handled here; for the second the system's default applies.
BOOL WINAPI onRequest(DWORD) {
  inhibitForce(InhibitReason::Interrupted);
  return wished.exchange(true) ? FALSE : TRUE;
}

}  // namespace

struct InterruptWatch::Before {};

InterruptWatch::InterruptWatch() : before_(std::make_unique<Before>()) {
  wished.store(false);
  SetConsoleCtrlHandler(onRequest, TRUE);
}

InterruptWatch::~InterruptWatch() {
  SetConsoleCtrlHandler(onRequest, FALSE);
  permitForce(InhibitReason::Interrupted);
}

bool InterruptWatch::seen() const noexcept { return wished.load(); }

}  // namespace moltact
