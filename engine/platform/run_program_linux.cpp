#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/platform/run_program.h"

extern char** environ;

namespace moltact {

namespace {

Problem notStarted(const std::vector<std::string>& words, int error) {
  return {words.empty() ? "" : words[0],
          0,
          0,
          trf("it cannot be started ({0})", std::system_category().message(error)),
          {}};
}

std::vector<char*> argumentsOf(const std::vector<std::string>& words) {
  std::vector<char*> out;
  for (const std::string& word : words) out.push_back(const_cast<char*>(word.c_str()));
  out.push_back(nullptr);
  return out;
}

}  // namespace

Expected<int> becomeProgram(const std::vector<std::string>& words) {
  if (words.empty()) return notStarted(words, EINVAL);
  execv(words[0].c_str(), argumentsOf(words).data());
  return notStarted(words, errno);
}

Expected<ProgramRun> runProgram(const std::vector<std::string>& words, bool quiet) {
  const auto failed = [&](int error) { return notStarted(words, error); };
  if (words.empty()) return failed(EINVAL);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return failed(errno);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  if (quiet) posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<char*> arguments = argumentsOf(words);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error != 0) {
    close(ends[0]);
    return failed(error);
  }
  ProgramRun out;
  constexpr std::size_t kMaxOutput_bytes = std::size_t(1) << 20;
  char buffer[4096];
  for (;;) {
    const ssize_t count = read(ends[0], buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    if (out.output.size() < kMaxOutput_bytes) out.output.append(buffer, std::size_t(count));
  }
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  out.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return out;
}

}  // namespace moltact
