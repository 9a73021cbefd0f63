#include <windows.h>

#include <atomic>

#include "engine/platform/force_inhibit.h"
#include "engine/platform/interrupt.h"

namespace moltact {
namespace {

std::atomic<bool> wished{false};

// On a thread of the system's. The first wish is ours; to the second the system answers in its own way.
BOOL WINAPI onWish(DWORD) {
  inhibitForce(InhibitReason::Interrupted);
  return wished.exchange(true) ? FALSE : TRUE;
}

}  // namespace

struct InterruptWatch::Before {};

InterruptWatch::InterruptWatch() : before_(std::make_unique<Before>()) {
  wished.store(false);
  SetConsoleCtrlHandler(onWish, TRUE);
}

InterruptWatch::~InterruptWatch() {
  SetConsoleCtrlHandler(onWish, FALSE);
  permitForce(InhibitReason::Interrupted);
}

bool InterruptWatch::seen() const noexcept { return wished.load(); }

}  // namespace moltact
