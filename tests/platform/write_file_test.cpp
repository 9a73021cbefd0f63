// A file has either its old or its new contents, whatever happens in between. Oracle: the bytes of both, and a listing
// of the folder.
#include "engine/platform/write_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>

#include "engine/platform/append_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path;
  Folder() {
    static int count = 0;
    path = fs::temp_directory_path() / ("moltact-write-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
};

void put(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

std::string get(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) out.insert(entry.path().filename().string());
  return out;
}

// What `act` returns in a process of its own: 0 to 100.
int inChild(const std::function<int()>& act) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(act());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 100 + WTERMSIG(status);
}

enum class Ended { Killed, ByItself, NotTraceable };

// Kills a process that does `act` at the `at`-th entry to or return from a system call.
Ended killedAt(int at, const std::function<void()>& act) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    ::raise(SIGSTOP);
    act();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, WUNTRACED);
  Ended ended = Ended::Killed;
  for (int k = 0; k < at && ended == Ended::Killed; ++k) {
    if (::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr) != 0)
      ended = Ended::NotTraceable;
    else
      ::waitpid(child, &status, 0);
    if (WIFEXITED(status)) return Ended::ByItself;
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, &status, 0);
  return ended;
}

const std::string kOld(3000, 'o'), kNew(2'500'000, 'n');  // larger than a single write

TEST_CASE(
    "killed at every one of its system calls, a writer leaves the old file or the new one, and the next writer leaves "
    "no draft of it") {
  int points = 0, old = 0;
  for (int at = 1;; ++at) {
    const Folder folder;
    const fs::path file = folder.path / "a.csv";
    put(file, kOld);
    const Ended ended = killedAt(at, [&] { (void)writeWhole(file, kNew); });
    if (ended == Ended::NotTraceable) {
      MESSAGE("left out: processes may not be traced here");
      return;
    }
    const std::string now = get(file);
    CAPTURE(at);
    CHECK((now == kOld || now == kNew));
    if (ended == Ended::ByItself) break;
    ++points;
    old += now == kOld;
    CHECK(names(folder.path).size() <= 2);
    CHECK_FALSE(writeWhole(folder.path / "b.csv", "other"));
    CHECK(names(folder.path) == std::set<std::string>{"a.csv", "b.csv"});
  }
  MESSAGE(points << " points, " << old << " of them with the old file");
  CHECK(points > 20);
  CHECK(old > 10);
  CHECK(old < points);
}

TEST_CASE(
    "a recording that replaces another one keeps the old file until its first piece is written, at every point of a "
    "kill") {
  for (int at = 1;; ++at) {
    const Folder folder;
    const fs::path file = folder.path / "a.recording";
    put(file, kOld);
    const Ended ended = killedAt(at, [&] {
      Expected<AppendFile> out = AppendFile::open(file, AppendFile::Begin::Replace);
      if (out) out->append("first");
      if (out) out->append("second");
    });
    if (ended == Ended::NotTraceable) return;
    const std::string now = get(file);
    CAPTURE(at);
    CHECK((now == kOld || now == "first" || now == "firstsecond"));
    if (ended == Ended::ByItself) break;
  }
}

// Runs `act` with a folder on a disk of 64 kB of which 4 are free; false where the system does not allow that.
bool onFullDisk(const std::function<int(const fs::path&)>& act, int& result) {
  const Folder folder;
  result = inChild([&] {
    if (::unshare(CLONE_NEWNS) != 0 || ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return 99;
    if (::mount("tmpfs", folder.path.c_str(), "tmpfs", 0, "size=64k") != 0) return 99;
    put(folder.path / "old", std::string(4000, 'o'));
    put(folder.path / "fill", std::string(56'000, 'f'));
    return act(folder.path);
  });
  return result != 99;
}

TEST_CASE("on a full disk the old file stays, nothing else is left, and the message says why") {
  int result = 0;
  const bool allowed = onFullDisk(
      [](const fs::path& disk) {
        const auto problem = writeWhole(disk / "old", std::string(30'000, 'n'));
        if (!problem || problem->text() != (disk / "old").string() + ": the disk is full; free some space on it")
          return 1;
        if (get(disk / "old") != std::string(4000, 'o')) return 2;
        if (!writeWhole(disk / "new", std::string(30'000, 'n'), IfThere::Refuse)) return 3;
        {
          Expected<AppendFile> growing = AppendFile::open(disk / "growing", AppendFile::Begin::New);
          if (!growing || !growing->append(std::string(30'000, 'n'))) return 4;
          Expected<AppendFile> instead = AppendFile::open(disk / "old", AppendFile::Begin::Replace);
          if (!instead || !instead->append(std::string(30'000, 'n'))) return 5;
        }
        if (names(disk) != std::set<std::string>{"fill", "old"}) return 6;
        // What fits is written.
        return writeWhole(disk / "old", "small") || get(disk / "old") != "small" ? 7 : 0;
      },
      result);
  if (!allowed)
    MESSAGE("left out: no disk may be mounted here");
  else
    CHECK(result == 0);
}

TEST_CASE("a limit on the size of files is a message and not the end of the program, and the old file stays") {
  const Folder folder;
  const fs::path file = folder.path / "a";
  put(file, "old");
  const int result = inChild([&] {
    takeSizeLimitsAsErrors();
    const rlimit most{10'000, 10'000};
    ::setrlimit(RLIMIT_FSIZE, &most);
    const auto problem = writeWhole(file, std::string(30'000, 'n'));
    return problem && problem->message == "it would grow larger than files may be here" ? 0 : 1;
  });
  CHECK(result == 0);
  CHECK(get(file) == "old");
  CHECK(names(folder.path) == std::set<std::string>{"a"});
}

TEST_CASE(
    "of 2 programs that write a file 300 times each at once none fails, and who reads it meanwhile meets one of "
    "theirs, whole") {
  const Folder folder;
  const fs::path file = folder.path / "settings.json";
  const std::string a(70'000, 'a'), b(90'000, 'b');
  put(file, a);
  const auto writer = [&](const std::string& text) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    int failed = 0;
    for (int k = 0; k < 300; ++k) failed += writeWhole(file, text).has_value();
    ::_exit(std::min(failed, 100));
  };
  const pid_t one = writer(a), two = writer(b);
  int ended = 0, failed = 0, torn = 0, looks = 0;
  while (ended < 2) {
    const std::string now = get(file);
    torn += now != a && now != b;
    ++looks;
    int status = 0;
    if (const pid_t which = ::waitpid(-1, &status, WNOHANG); which == one || which == two) {
      ++ended;
      failed += WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    }
  }
  MESSAGE(looks << " looks");
  CHECK(failed == 0);
  CHECK(torn == 0);
  CHECK(names(folder.path) == std::set<std::string>{"settings.json"});
}

TEST_CASE("a link is followed, rights are kept, a read-only file and one that is not to be replaced stay") {
  const Folder folder;
  const fs::path real = folder.path / "real", link = folder.path / "link", loose = folder.path / "loose";
  put(real, "old");
  ::chmod(real.c_str(), 0640);
  fs::create_symlink("real", link);
  CHECK_FALSE(writeWhole(link, "new"));
  CHECK(fs::is_symlink(link));
  CHECK(get(real) == "new");
  struct stat is {};
  ::stat(real.c_str(), &is);
  CHECK((is.st_mode & 07777) == 0640);
  fs::create_symlink("later", loose);
  CHECK_FALSE(writeWhole(loose, "made"));
  CHECK(get(folder.path / "later") == "made");
  CHECK(writeWhole(real, "newer", IfThere::Refuse)->message == "it is already there");
  CHECK(get(real) == "new");
  CHECK(writeWhole(folder.path, "x")->message == "it is a folder");
  CHECK(writeWhole(folder.path / "none" / "x", "x")->message == "its folder is not there");
  CHECK(writeWhole(folder.path / std::string(300, 'x'), "x")->message == "its name is too long");
  if (::geteuid() != 0) {
    ::chmod(real.c_str(), 0440);
    CHECK(writeWhole(real, "newer")->message == "it may not be written");
    CHECK(get(real) == "new");
  }
}

TEST_CASE("a device and a pipe are written to as they are") {
  CHECK_FALSE(writeWhole("/dev/null", kNew));
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(writeWhole("/dev/full", "x")->text() == "/dev/full: the disk is full; free some space on it");
  const Folder folder;
  const fs::path pipe = folder.path / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  CHECK_FALSE(writeWhole(pipe, "through"));
  char bytes[16] = {};
  CHECK(::read(reader, bytes, sizeof bytes) == 7);
  ::close(reader);
  CHECK(fs::is_fifo(pipe));
}

TEST_CASE("drafts of programs that have ended go, those of running ones and other files stay") {
  const Folder folder;
  put(folder.path / ".moltact-0123abcd-left.csv", "half");
  put(folder.path / ".moltact-0123abcx-mine", "no draft");
  put(folder.path / ".moltact-notes", "no draft");
  Expected<Draft> open = Draft::begin(folder.path / "open.csv");
  REQUIRE(bool(open));
  CHECK_FALSE(writeWhole(folder.path / "a.csv", "a"));
  CHECK(names(folder.path) ==
        std::set<std::string>{open->path().filename().string(), ".moltact-0123abcx-mine", ".moltact-notes", "a.csv"});
  CHECK_FALSE(open->append("whole"));
  CHECK_FALSE(open->commit());
  CHECK(get(folder.path / "open.csv") == "whole");
}

TEST_CASE("a file that only grows and to which nothing was appended goes again; what it was to replace stays") {
  const Folder folder;
  { REQUIRE(bool(AppendFile::open(folder.path / "new", AppendFile::Begin::New))); }
  CHECK(names(folder.path).empty());
  put(folder.path / "old", "old");
  { REQUIRE(bool(AppendFile::open(folder.path / "old", AppendFile::Begin::Replace))); }
  CHECK(get(folder.path / "old") == "old");
  Expected<AppendFile> growing = AppendFile::open(folder.path / "old", AppendFile::Begin::Replace);
  REQUIRE(bool(growing));
  CHECK_FALSE(growing->append("a"));
  CHECK_FALSE(growing->append("b"));
  CHECK(get(folder.path / "old") == "ab");
  // Who writes it keeps others away.
  CHECK(AppendFile::open(folder.path / "old", AppendFile::Begin::Replace).problem().message ==
        "another Moltact is writing it");
}

}  // namespace
}  // namespace moltact
