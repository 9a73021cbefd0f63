// In a page no signal comes and no act outlives it: a device that gives force ends it by its own watchdog.
#include <atomic>

#include "engine/platform/force_hold.h"

namespace moltact {
namespace {
std::atomic<unsigned> held{0};
}

bool forceHeld() noexcept { return held.load(std::memory_order_relaxed) != 0; }
void holdForce(Hold why) noexcept { held.fetch_or(unsigned(why)); }
void letForce(Hold why) noexcept { held.fetch_and(~unsigned(why)); }
void endForce() noexcept { holdForce(Hold::Dying); }

bool LastAct::arm(Act, void*) noexcept { return false; }
void LastAct::disarm() noexcept {}

CrashStack::CrashStack() noexcept = default;
CrashStack::~CrashStack() = default;

}  // namespace moltact
