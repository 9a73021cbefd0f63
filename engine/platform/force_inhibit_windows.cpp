#include <windows.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>

#include "engine/platform/force_inhibit.h"

namespace moltact {
namespace {

std::atomic<unsigned> inhibited{0};

// A slot is taken when `data` and then `act` are there, so that whoever ends the process sees both or none.
struct Slot {
  std::atomic<bool> taken{false};
  std::atomic<void*> data{nullptr};
  std::atomic<LastAct::Act> act{nullptr};
  std::atomic<int> inside{0};
};
std::array<Slot, LastAct::kMost> slots;

bool doIt(Slot& slot) noexcept {
  slot.inside.fetch_add(1);
  const LastAct::Act act = slot.act.load();
  const bool done = !act || act(slot.data.load());
  slot.inside.fetch_sub(1);
  return done;
}

// A crash on any thread; then the system goes on with it as without us.
LONG WINAPI onCrash(EXCEPTION_POINTERS*) {
  endForce();
  return EXCEPTION_CONTINUE_SEARCH;
}

void install() noexcept {
  static std::once_flag once;
  try {
    std::call_once(once, [] {
      SetUnhandledExceptionFilter(onCrash);
      std::atexit([] { endForce(); });
    });
  } catch (...) {  // no lock could be had: then without
  }
}

}  // namespace

bool forceInhibited() noexcept { return inhibited.load(std::memory_order_acquire) != 0; }
void inhibitForce(InhibitReason why) noexcept { inhibited.fetch_or(static_cast<unsigned>(why)); }
void permitForce(InhibitReason why) noexcept { inhibited.fetch_and(~static_cast<unsigned>(why)); }

// Each act until it is done, and once more: a thread that was about to give a force may have given it after the act.
void endForce() noexcept {
  inhibitForce(InhibitReason::Dying);
  std::array<bool, LastAct::kMost> done{};
  const ULONGLONG until_ms = GetTickCount64() + kPatience_ms;
  for (bool all = false; !all && GetTickCount64() < until_ms;) {
    all = true;
    for (std::size_t k = 0; k < slots.size(); ++k) all = (done[k] = done[k] || doIt(slots[k])) && all;
    if (!all) Sleep(1);
  }
  for (Slot& slot : slots) doIt(slot);
}

bool LastAct::arm(Act act, void* data) noexcept {
  disarm();
  install();
  for (int k = 0; k < kMost; ++k) {
    Slot& slot = slots[std::size_t(k)];
    if (slot.taken.exchange(true)) continue;
    slot.data.store(data);
    slot.act.store(act);
    slot_ = k;
    return true;
  }
  return false;
}

void LastAct::disarm() noexcept {
  if (slot_ < 0) return;
  Slot& slot = slots[std::size_t(slot_)];
  slot.act.store(nullptr);
  while (slot.inside.load() > 0) Sleep(0);
  slot.taken.store(false);
  slot_ = -1;
}

// A HID device of Windows is no file that takes a report as it is: there the device's own watchdog ends the force.
LastReport::~LastReport() = default;
bool LastReport::arm(const char*, std::span<const std::uint8_t>) noexcept { return false; }

// The system reports a stack that is full as a crash like others.
CrashStack::CrashStack() noexcept = default;
CrashStack::~CrashStack() = default;

}  // namespace moltact
