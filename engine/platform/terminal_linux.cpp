#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "engine/platform/terminal.h"

namespace moltact {

bool standardErrorIsTerminal() { return ::isatty(STDERR_FILENO) == 1; }

Typed typedLine(std::string& line, int wait_ms) {
  static std::string typed;  // what came after the last line
  std::size_t end = typed.find('\n');
  if (end == std::string::npos) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, wait_ms) <= 0) return Typed::Nothing;
    char some[256];
    const ssize_t size = ::read(STDIN_FILENO, some, sizeof some);
    if (size < 0 && (errno == EINTR || errno == EAGAIN)) return Typed::Nothing;
    if (size <= 0) return Typed::End;
    typed.append(some, std::size_t(size));
    end = typed.find('\n');
    if (end == std::string::npos) return Typed::Nothing;
  }
  line = typed.substr(0, end);
  typed.erase(0, end + 1);
  return Typed::Line;
}

}  // namespace moltact
