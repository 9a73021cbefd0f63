// A page receives no signals, and no act outlives it: a device with force needs its own watchdog.
#include <atomic>

#include "engine/platform/force_inhibit.h"

namespace moltact {
namespace {
std::atomic<unsigned> inhibited{0};
}

bool forceInhibited() noexcept { return inhibited.load(std::memory_order_relaxed) != 0; }
void inhibitForce(InhibitReason why) noexcept { inhibited.fetch_or(unsigned(why)); }
void permitForce(InhibitReason why) noexcept { inhibited.fetch_and(~unsigned(why)); }
bool forceEnded() noexcept { return (inhibited.load(std::memory_order_relaxed) & unsigned(InhibitReason::Dying)) != 0; }
void endForce() noexcept { inhibitForce(InhibitReason::Dying); }

bool LastAct::arm(Act, void*) noexcept { return false; }
void LastAct::disarm() noexcept {}

CrashStack::CrashStack() noexcept = default;
CrashStack::~CrashStack() = default;

}  // namespace moltact
