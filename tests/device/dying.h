// Runs a program as a child of the test, most often a dying_hand (dying_hand.cpp): starts it, waits for it, kills it.
// Linux.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "engine/platform/realtime.h"

extern char** environ;

namespace moltact::test {

/// A child process of the test.
class Child {
 public:
  explicit Child(std::vector<std::string> arguments) {
    int ends[2], in[2];
    REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
    REQUIRE(::pipe2(in, O_CLOEXEC) == 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
    // The child resets the signals that the test's own process ignores.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&attributes, &all);
    std::vector<char*> pointers;
    for (std::string& one : arguments) pointers.push_back(one.data());
    pointers.push_back(nullptr);
    REQUIRE(::posix_spawn(&pid_, pointers[0], &actions, &attributes, pointers.data(), environ) == 0);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    ::close(ends[1]);
    ::close(in[0]);
    out_ = ends[0];
    in_ = in[1];
  }
  ~Child() {
    ::close(out_);
    ::close(in_);
    if (pid_ > 0) ::kill(pid_, SIGKILL), ::waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The next line of its output, if it comes within `wait_ms`; otherwise empty.
  std::string line(int wait_ms) {
    for (;;) {
      if (const auto end = text_.find('\n'); end != std::string::npos) {
        const std::string one = text_.substr(0, end);
        text_.erase(0, end + 1);
        return one;
      }
      pollfd input{out_, POLLIN, 0};
      char some[256];
      if (::poll(&input, 1, wait_ms) <= 0) return "";
      const ssize_t size = ::read(out_, some, sizeof some);
      if (size <= 0) return "";
      text_.append(some, std::size_t(size));
    }
  }
  /// Permits the child to end itself in the requested way.
  void go() { REQUIRE(::write(in_, "\n", 1) == 1); }
  void send(int signal) {
    at_ns_ = monotonic_ns();
    REQUIRE(::kill(pid_, signal) == 0);
  }
  /// Whether it has ended; its status is then that of waitpid.
  bool over() {
    if (pid_ <= 0) return true;
    if (::waitpid(pid_, &status_, WNOHANG) != pid_) return false;
    pid_ = -1;
    if (at_ns_ == 0) at_ns_ = std::strtoll(line(0).c_str(), nullptr, 10);
    return true;
  }
  bool killedBy(int signal) const { return WIFSIGNALED(status_) && WTERMSIG(status_) == signal; }
  bool exitedWith(int status) const { return WIFEXITED(status_) && WEXITSTATUS(status_) == status; }
  int status() const { return status_; }
  int pid() const { return pid_; }
  /// The time when it received its signal, or began to end itself.
  std::int64_t at_ns() const { return at_ns_; }

 private:
  pid_t pid_ = -1;
  int out_ = -1, in_ = -1, status_ = 0;
  std::int64_t at_ns_ = 0;
  std::string text_;
};

/// A child process dying_hand (dying_hand.cpp).
class Dying : public Child {
 public:
  Dying(const std::string& device, const std::string& way) : Child({MOLTACT_DYING_HAND, device, way}) {}
};

/// A way to end, and the expected result for the process.
struct WayToDie {
  const char* way;  ///< argument of dying_hand; "wait": by a signal
  int signal;       ///< that it receives, or dies of; 0: it exits with status 7
};
inline const WayToDie kWaysToDie[] = {
    {"wait", SIGINT},
    {"wait", SIGTERM},
    {"wait", SIGHUP},
    {"wait", SIGQUIT},
    {"wait", SIGPIPE},
    {"wait", SIGUSR1},
    {"wait", SIGALRM},
    {"wait", SIGXCPU},
    {"wait", SIGXFSZ},
    {"wait", SIGSEGV},
    {"wait", SIGBUS},
    {"wait", SIGFPE},
    {"wait", SIGILL},
    {"wait", SIGABRT},
    {"wait", SIGTRAP},
    {"wait", SIGSYS},
    {"wait", SIGRTMIN},
    {"wait", SIGRTMIN + 1},
    {"wait", (SIGRTMIN + SIGRTMAX) / 2},
    {"wait", SIGRTMAX},
    {"segv", SIGSEGV},
    {"abort", SIGABRT},
    {"terminate", SIGABRT},
    {"stack", SIGSEGV},
    {"segv elsewhere", SIGSEGV},
    {"throw elsewhere", SIGABRT},
    {"tick", SIGABRT},
    {"exit", 0},
    {"exit elsewhere", 0},
    {"throw", 0},
};
/// Time limit on a busy machine for the last message, or for filling a stack; for an idle machine see docs/safety.md.
inline constexpr double kBusy_ms = 500;

}  // namespace moltact::test
