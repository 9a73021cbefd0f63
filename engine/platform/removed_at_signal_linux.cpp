#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <system_error>
#include <thread>

#include "engine/platform/removed_at_signal.h"

namespace moltact {

namespace fs = std::filesystem;

// The signals are blocked and received by a separate thread, because a handler must not remove files.
struct RemovedAtSignal::Impl {
  fs::path folder;
  sigset_t wanted{}, before{};
  int signals = -1, end = -1;
  std::thread thread;

  void watch() const {
    pollfd both[] = {{signals, POLLIN, 0}, {end, POLLIN, 0}};
    while (::poll(both, 2, -1) < 0 && errno == EINTR) {
    }
    signalfd_siginfo signal{};
    if (both[1].revents || ::read(signals, &signal, sizeof signal) != ssize_t(sizeof signal)) return;
    std::error_code ignored;
    // The command continues meanwhile and may write another file.
    for (int tries = 0; tries < 5 && fs::exists(folder, ignored); ++tries) fs::remove_all(folder, ignored);
    const int number = int(signal.ssi_signo);
    std::signal(number, SIG_DFL);
    ::raise(number);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, number);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  }
};

RemovedAtSignal::RemovedAtSignal(const fs::path& folder) : impl_(std::make_unique<Impl>()) {
  impl_->folder = folder;
  sigemptyset(&impl_->wanted);
  // Signals that the program's caller has set to be ignored stay ignored.
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction is {};
    if (sigaction(number, nullptr, &is) == 0 && is.sa_handler == SIG_DFL) sigaddset(&impl_->wanted, number);
  }
  pthread_sigmask(SIG_BLOCK, &impl_->wanted, &impl_->before);
  impl_->signals = signalfd(-1, &impl_->wanted, SFD_CLOEXEC);
  impl_->end = eventfd(0, EFD_CLOEXEC);
  if (impl_->signals >= 0 && impl_->end >= 0) try {
      impl_->thread = std::thread([impl = impl_.get()] { impl->watch(); });
      return;
    } catch (const std::system_error&) {
    }
  pthread_sigmask(SIG_SETMASK, &impl_->before, nullptr);  // without a thread signals end the program immediately
}

RemovedAtSignal::~RemovedAtSignal() {
  const std::uint64_t one = 1;
  if (impl_->thread.joinable()) {
    (void)!::write(impl_->end, &one, sizeof one);
    impl_->thread.join();
    pthread_sigmask(SIG_SETMASK, &impl_->before, nullptr);
  }
  if (impl_->signals >= 0) ::close(impl_->signals);
  if (impl_->end >= 0) ::close(impl_->end);
}

}  // namespace moltact
