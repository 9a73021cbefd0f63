#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "engine/platform/terminal_calls.h"

void moltact::hideOwnTerminal() {}

namespace moltact::platform {
namespace {

int handleOf(Output to) { return to == Output::Standard ? STDOUT_FILENO : STDERR_FILENO; }

}  // namespace

void prepare(Output) {}

std::size_t writeSome(Output to, std::string_view bytes) {
  ssize_t written = ::write(handleOf(to), bytes.data(), bytes.size());
  while (written < 0 && errno == EINTR) written = ::write(handleOf(to), bytes.data(), bytes.size());
  return written > 0 ? std::size_t(written) : 0;
}

bool isTerminal(Output to) { return ::isatty(handleOf(to)) == 1; }

Typed readSome(std::string& typed, int wait_ms) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, wait_ms) <= 0) return Typed::Nothing;
  char some[256];
  const ssize_t size = ::read(STDIN_FILENO, some, sizeof some);
  if (size < 0 && (errno == EINTR || errno == EAGAIN)) return Typed::Nothing;
  if (size <= 0) return Typed::End;
  typed.append(some, std::size_t(size));
  return Typed::Line;
}

}  // namespace moltact::platform
