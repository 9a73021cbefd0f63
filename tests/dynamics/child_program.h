// A program that a test starts, and that ends with the test at the latest. Linux.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace moltact::test {

class ChildProgram {
 public:
  /// Runs `words` in `folder`; its output goes to the file `log` there.
  ChildProgram(std::vector<std::string> words, const std::string& folder, const std::string& log) {
    id_ = ::fork();
    REQUIRE(id_ >= 0);
    if (id_ > 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), none = ::open("/dev/null", O_RDONLY);
    ::dup2(none, 0);
    ::dup2(file, 1);
    ::dup2(file, 2);
    std::vector<char*> list;
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    ::execvp(list[0], list.data());
    ::_exit(127);
  }
  ~ChildProgram() { kill(); }
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  void signal(int number) const {
    if (id_ > 0) ::kill(id_, number);
  }
  void kill() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
    id_ = -1;
  }
  bool ended() {
    if (id_ > 0 && ::waitpid(id_, nullptr, WNOHANG) == id_) id_ = -1;
    return id_ < 0;
  }

 private:
  pid_t id_ = -1;
};

/// Whether the shell finds a program of this name.
inline bool hasProgram(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// Whether a test cannot run because a program is missing. It says so; where MOLTACT_FULL=1 asks for all tests, it fails.
inline bool lacksProgram(const std::string& name, const std::string& package) {
  if (hasProgram(name)) return false;
  const char* const full = std::getenv("MOLTACT_FULL");
  const std::string why = "not run: the program " + name + " is not installed (Debian: " + package + ")";
  if (full && *full == '1')
    FAIL_CHECK(why);
  else
    MESSAGE(why);
  return true;
}

/// A port on which nothing listens.
inline std::uint16_t freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof at;
  REQUIRE(::bind(socket, reinterpret_cast<sockaddr*>(&at), sizeof at) == 0);
  REQUIRE(::getsockname(socket, reinterpret_cast<sockaddr*>(&at), &size) == 0);
  ::close(socket);
  return ntohs(at.sin_port);
}

}  // namespace moltact::test
