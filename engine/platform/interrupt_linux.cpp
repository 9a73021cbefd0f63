#include <array>
#include <atomic>
#include <csignal>

#include "engine/platform/force_inhibit.h"
#include "engine/platform/interrupt.h"

namespace moltact {
namespace {

constexpr std::array kWishes{SIGINT, SIGTERM, SIGHUP};
std::atomic<bool> wished{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal's handler may set it");

}  // namespace

struct InterruptWatch::Before {
  std::array<struct sigaction, kWishes.size()> actions;
};

InterruptWatch::InterruptWatch() : before_(std::make_unique<Before>()) {
  wished.store(false);
  struct sigaction action {};
  // The force ends immediately; the owner of the InterruptWatch closes the device later.
  action.sa_handler = [](int) {
    inhibitForce(InhibitReason::Interrupted);
    wished.store(true);
  };
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // without SA_RESTART, so that waiting for input ends
  for (std::size_t k = 0; k < kWishes.size(); ++k) sigaction(kWishes[k], &action, &before_->actions[k]);
}

InterruptWatch::~InterruptWatch() {
  for (std::size_t k = 0; k < kWishes.size(); ++k) sigaction(kWishes[k], &before_->actions[k], nullptr);
  permitForce(InhibitReason::Interrupted);
}

bool InterruptWatch::seen() const noexcept { return wished.load(); }

}  // namespace moltact
