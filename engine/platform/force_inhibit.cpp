// The part common to all systems that can end a process and leave its devices without commands.
#include "engine/platform/force_inhibit.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>

#include "engine/platform/force_inhibit_calls.h"

namespace moltact {
namespace {

std::atomic<unsigned> inhibited{0};
static_assert(std::atomic<unsigned>::is_always_lock_free, "a signal's handler sets it");

// A slot is valid when `data` and then `act` are set, so that a handler sees both or neither.
struct Slot {
  std::atomic<bool> taken{false};
  std::atomic<void*> data{nullptr};
  std::atomic<LastAct::Act> act{nullptr};
  std::atomic<int> inside{0};  // number of handlers inside
};
std::array<Slot, LastAct::kMax> slots;

bool doIt(Slot& slot) noexcept {
  slot.inside.fetch_add(1);
  const LastAct::Act act = slot.act.load();
  const bool done = !act || act(slot.data.load());
  slot.inside.fetch_sub(1);
  return done;
}

}  // namespace

// Performs each act until it is done. A thread that was about to give a force when it was inhibited may still give it
// after the act, so each act is performed once more.
void platform::doLastActs() noexcept {
  constexpr std::int64_t kLook_ns = 200'000, kOvertaken_ns = 1'000'000;
  std::array<bool, LastAct::kMax> done{};
  const auto all = [&] {
    bool every = true;
    for (std::size_t k = 0; k < slots.size(); ++k) every = (done[k] = done[k] || doIt(slots[k])) && every;
    return every;
  };
  if (std::none_of(slots.begin(), slots.end(), [](const Slot& p) { return p.act.load(); })) return;
  for (const std::int64_t until_ns = platform::now_ns() + kPatience_ms * std::int64_t{1'000'000};
       !all() && platform::now_ns() < until_ns;)
    platform::rest_ns(kLook_ns);
  platform::rest_ns(kOvertaken_ns);
  for (Slot& slot : slots) doIt(slot);
}

bool forceInhibited() noexcept { return inhibited.load(std::memory_order_acquire) != 0; }
bool forceEnded() noexcept { return (inhibited.load() & static_cast<unsigned>(InhibitReason::Dying)) != 0; }
void inhibitForce(InhibitReason why) noexcept { inhibited.fetch_or(static_cast<unsigned>(why)); }
void permitForce(InhibitReason why) noexcept { inhibited.fetch_and(~static_cast<unsigned>(why)); }

void endForce() noexcept {
  const int kept = errno;
  inhibitForce(InhibitReason::Dying);
  platform::doLastActs();
  errno = kept;
}

bool LastAct::arm(Act act, void* data) noexcept {
  disarm();
  platform::catchEndings();
  for (int k = 0; k < kMax; ++k) {
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
  while (slot.inside.load() > 0) platform::rest_ns(100'000);  // waits for a handler that is inside
  slot.taken.store(false);
  slot_ = -1;
}

}  // namespace moltact
