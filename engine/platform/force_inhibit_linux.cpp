#include <fcntl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <mutex>

#include "engine/platform/force_inhibit.h"
#include "engine/platform/force_inhibit_calls.h"

namespace moltact {
namespace {

// Signals that end a process: its own faults, with any handler; and signals sent by others, unless they are handled.
constexpr std::array kFaults{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};
constexpr std::array kSent{SIGHUP,  SIGINT,  SIGQUIT,   SIGTERM, SIGPIPE, SIGALRM, SIGUSR1,  SIGUSR2,
                           SIGXCPU, SIGXFSZ, SIGVTALRM, SIGPROF, SIGPOLL, SIGPWR,  SIGSTKFLT};
// Signals that stop the process with all its threads.
constexpr std::array kStops{SIGTSTP, SIGTTIN, SIGTTOU};
std::array<struct sigaction, 65> before;

void onEnd(int signal, siginfo_t* info, void*) noexcept {
  endForce();
  // Continues as without a handler: a fault repeats itself, a sent signal is sent again.
  sigaction(signal, &before[std::size_t(signal)], nullptr);
  const bool again =
      info && info->si_code > 0 && (signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL);
  if (!again) raise(signal);
}

void onStop(int) noexcept {
  const int kept = errno;
  inhibitForce(InhibitReason::Stopped);
  platform::doLastActs();
  raise(SIGSTOP);
  permitForce(InhibitReason::Stopped);  // continued: the loop detects the stall and starts softly
  errno = kept;
}

void take(int signal, void (*handler)(int, siginfo_t*, void*), bool though_taken) {
  struct sigaction now {};
  sigaction(signal, nullptr, &now);
  const bool is_default = !(now.sa_flags & SA_SIGINFO) && now.sa_handler == SIG_DFL;
  const bool ignored = !(now.sa_flags & SA_SIGINFO) && now.sa_handler == SIG_IGN;
  if (ignored || (!is_default && !though_taken)) return;
  before[std::size_t(signal)] = now;
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void platform::rest_ns(std::int64_t time) noexcept {
  const timespec wait{time / 1'000'000'000, time % 1'000'000'000};
  nanosleep(&wait, nullptr);
}

std::int64_t platform::now_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

void platform::catchEndings() noexcept {
  static std::once_flag once;
  try {
    std::call_once(once, [] {
      for (const int signal : kFaults) take(signal, onEnd, true);
      for (const int signal : kSent) take(signal, onEnd, false);
      for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) take(signal, onEnd, false);
      for (const int signal : kStops)
        take(
            signal, [](int s, siginfo_t*, void*) { onStop(s); }, false);
      std::atexit([] { endForce(); });
      std::at_quick_exit([] { endForce(); });
    });
  } catch (...) {  // without a lock
  }
}

LastReport::~LastReport() {
  act_.disarm();
  if (file_ >= 0) ::close(file_);
}

bool LastReport::arm(const char* path, std::span<const std::uint8_t> report) noexcept {
  act_.disarm();
  if (file_ < 0) file_ = ::open(path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (file_ < 0) return false;
  size_ = std::min(report.size(), sizeof report_);
  std::copy_n(report.begin(), size_, report_);
  return act_.arm(&LastReport::write, this);
}

bool LastReport::write(void* data) noexcept {
  const LastReport& self = *static_cast<const LastReport*>(data);
  // A disconnected device needs no command: there is nothing to try again.
  (void)!::write(self.file_, self.report_, self.size_);
  return true;
}

CrashStack::CrashStack() noexcept {
  constexpr std::size_t kBytes = 64 * 1024;
  stack_t now{};
  // An existing stack, such as a sanitizer's, is kept.
  if (sigaltstack(nullptr, &now) != 0 || !(now.ss_flags & SS_DISABLE)) return;
  stack_ = std::malloc(kBytes);
  if (!stack_) return;
  stack_t mine{};
  mine.ss_sp = stack_;
  mine.ss_size = kBytes;
  if (sigaltstack(&mine, nullptr) == 0) return;
  std::free(stack_);
  stack_ = nullptr;
}

CrashStack::~CrashStack() {
  if (!stack_) return;
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  sigaltstack(&none, nullptr);
  std::free(stack_);
}

}  // namespace moltact
