// The folders of lessons for all users of a computer, after the XDG base directory specification.
#include "engine/platform/folders.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/platform/removed_at_signal.h"
#include "engine/platform/temporary_folder.h"

using namespace moltact;
namespace fs = std::filesystem;

namespace {

// Sets an environment variable until the end of the test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* was = std::getenv(name)) was_ = was;
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~Variable() { was_ ? ::setenv(name_, was_->c_str(), 1) : ::unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> was_;
};

}  // namespace

TEST_CASE(
    "shared data are in moltact of each folder of XDG_DATA_DIRS, in order; relative and empty ones are passed over") {
  const Variable dirs("XDG_DATA_DIRS", "/srv/school:here/not::/opt/x/");
  CHECK(sharedDataFolders() == std::vector<fs::path>{"/srv/school/moltact", "/opt/x/moltact"});
}

TEST_CASE("without XDG_DATA_DIRS shared data are under /usr/local/share and /usr/share") {
  for (const char* none : {static_cast<const char*>(nullptr), ""}) {
    const Variable dirs("XDG_DATA_DIRS", none);
    CHECK(sharedDataFolders() == std::vector<fs::path>{"/usr/local/share/moltact", "/usr/share/moltact"});
  }
}

TEST_CASE("the program's own data are not among the shared ones, though they lie in a folder of XDG_DATA_DIRS") {
  const fs::path share = fs::temp_directory_path() / "moltact-folders-test";
  fs::create_directories(share / "moltact");
  const Variable home("MOLTACT_HOME", (share / "moltact").c_str()),
      dirs("XDG_DATA_DIRS", (share.string() + ":/srv").c_str());
  CHECK(sharedDataFolders() == std::vector<fs::path>{"/srv/moltact"});
  fs::remove_all(share);
}

TEST_CASE("a program that SIGINT, SIGTERM or SIGHUP ends removes its temporary folder and ends by that signal") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    CAPTURE(signal);
    int ready[2];
    REQUIRE(::pipe(ready) == 0);
    const std::filesystem::path place =
        std::filesystem::temp_directory_path() / ("moltact-signal-" + std::to_string(::getpid()));
    std::filesystem::create_directories(place);
    const pid_t child = ::fork();
    if (child == 0) {
      for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_DFL);  // as a command begins
      auto folder = moltact::TemporaryFolder::in(place, "own-");
      const moltact::RemovedAtSignal removed(folder->path());
      std::filesystem::create_directories(folder->path() / "deep");
      (void)!::write(ready[1], "r", 1);
      for (;;) ::pause();
    }
    char sign = 0;
    REQUIRE(::read(ready[0], &sign, 1) == 1);
    CHECK_FALSE(std::filesystem::is_empty(place));
    // While in use it is not swept.
    moltact::sweepTemporaryFolders(place, "own-");
    CHECK_FALSE(std::filesystem::is_empty(place));
    ::kill(child, signal);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(std::filesystem::is_empty(place));
    // What is left by a killed one is.
    std::filesystem::create_directories(place / "own-left" / "deep");
    moltact::sweepTemporaryFolders(place, "own-");
    CHECK(std::filesystem::is_empty(place));
    std::filesystem::remove_all(place);
    ::close(ready[0]);
    ::close(ready[1]);
  }
}
