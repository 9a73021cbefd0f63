// Oracle: the lines passed to the writer, in order. Processes are really killed and disks really filled.
#include "engine/results/attempt_writer.h"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>
#include <thread>

#include "engine/results/attempt_file.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

std::string hint(int number) { return lineOf({double(number), HintOpened{"step " + std::to_string(number)}}); }

// Runs a function in a process of its own; gives its exit status, or 128 and the signal that ended it.
template <class Function>
int inChild(Function function) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(function());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST_CASE("a writer killed at 20 random moments leaves every line that it had acknowledged, in order, and no other") {
  const unsigned seed = std::random_device{}();
  MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 20; ++round) {
    const ScratchFolder scratch;
    int pipe[2];
    REQUIRE(::pipe(pipe) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      AttemptWriter writer = AttemptWriter::startNew(scratch.path, "killed");
      writer.append(lineOf(sampleHeader()));
      for (int number = 0;; ++number) {
        writer.append(hint(number));
        if (number % 7 == 0 && writer.flush() && ::write(pipe[1], &number, sizeof number) < 0) ::_exit(1);
      }
    }
    ::close(pipe[1]);
    int acknowledged = -1;
    const int wait_for = int(random() % 60);
    for (int k = 0; k <= wait_for; ++k)
      REQUIRE(::read(pipe[0], &acknowledged, sizeof acknowledged) == sizeof acknowledged);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(pipe[0]);

    mendAttempts(scratch.path);
    const Expected<Attempt> read = readAttempt(scratch.path / "killed.jsonl");
    REQUIRE(bool(read));
    CHECK(read->problems.empty());
    CHECK_FALSE(read->torn);
    REQUIRE(int(read->events.size()) > acknowledged);
    for (std::size_t k = 0; k < read->events.size(); ++k) REQUIRE(read->events[k].t_s == double(k));
  }
}

TEST_CASE(
    "a disk with room for half a line is reported once, keeps whole lines only, and gets all 500 "
    "once there is room") {
  const ScratchFolder scratch;
  const int status = inChild([&] {
    ::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit then fails as on a full disk, after part of it was written
    AttemptWriter writer = AttemptWriter::startNew(scratch.path, "full");
    writer.append(lineOf(sampleHeader()));
    writer.append(hint(0));
    if (!writer.flush() || writer.takeFault()) return 1;
    const std::string before = bytesOf(writer.file());
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlim_t free_again = limit.rlim_cur;
    limit.rlim_cur = before.size() + 20;
    ::setrlimit(RLIMIT_FSIZE, &limit);
    for (int k = 1; k < 250; ++k) writer.append(hint(k));
    if (writer.flush()) return 2;
    if (bytesOf(writer.file()) != before) return 3;
    if (!writer.takeFault()) return 4;
    for (int k = 250; k < 500; ++k) writer.append(hint(k));
    if (writer.flush()) return 5;
    if (writer.takeFault()) return 6;  // already reported
    limit.rlim_cur = free_again;
    ::setrlimit(RLIMIT_FSIZE, &limit);
    if (!writer.flush() || !writer.takeRecovered()) return 7;
    const Expected<Attempt> read = readAttempt(writer.file());
    if (!read || read->events.size() != 500 || !read->problems.empty()) return 8;
    for (std::size_t k = 0; k < 500; ++k)
      if (read->events[k].t_s != double(k)) return 9;
    return 0;
  });
  CHECK(status == 0);
}

TEST_CASE("a device that is always full is reported in words to act on, and ending the writer does not hang") {
  AttemptWriter writer = AttemptWriter::resume("/dev/full");
  writer.append(hint(1));
  CHECK_FALSE(writer.flush());
  const std::optional<Problem> fault = writer.takeFault();
  REQUIRE(fault.has_value());
  CHECK(fault->text() == "/dev/full: the disk is full; free some space on it");
  writer.append(hint(2));
  CHECK_FALSE(writer.flush());
  CHECK_FALSE(writer.takeFault().has_value());
}

TEST_CASE("a folder that cannot be made or written is reported, and what waited is written once it can be") {
  const ScratchFolder scratch;
  const fs::path blocked = scratch.path / "file";
  writeFile(blocked, "no folder");
  AttemptWriter writer = AttemptWriter::startNew(blocked / "attempts", "a");
  writer.append(lineOf(sampleHeader()));
  CHECK_FALSE(writer.flush());
  REQUIRE(writer.takeFault().has_value());
  CHECK(writer.file().empty());
  fs::remove(blocked);
  CHECK(writer.flush());
  CHECK(writer.takeRecovered());
  CHECK(bool(readAttempt(blocked / "attempts" / "a.jsonl")));

  if (::geteuid() != 0) {  // root may write anywhere
    const fs::path locked = scratch.path / "locked";
    fs::create_directory(locked);
    fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
    AttemptWriter refused = AttemptWriter::startNew(locked, "a");
    refused.append(lineOf(sampleHeader()));
    CHECK_FALSE(refused.flush());
    CHECK(refused.takeFault()->remedy == "allow writing to it and to its folder");
    fs::permissions(locked, fs::perms::owner_all);
  }
  AttemptWriter nowhere = AttemptWriter::startNew({}, "a");
  nowhere.append(lineOf(sampleHeader()));
  CHECK_FALSE(nowhere.flush());
  CHECK(nowhere.takeFault().has_value());
}

TEST_CASE(
    "80 lines of 1 MiB while the disk takes none: 31 or more are kept in order, the next line that finds room has a "
    "mark "
    "before it, and what is kept and what the mark counts are 80 together") {
  const ScratchFolder scratch;
  const fs::path blocked = scratch.path / "file";
  writeFile(blocked, "no folder");
  AttemptWriter writer = AttemptWriter::startNew(blocked / "attempts", "a");
  writer.append(lineOf(sampleHeader()));
  REQUIRE_FALSE(writer.flush());
  for (int k = 0; k < 80; ++k) {
    std::string line = hint(k);
    line.insert(line.size() - 1, std::size_t{1} << 20, ' ');
    writer.append(std::move(line));
  }
  fs::remove(blocked);
  REQUIRE(writer.flush());
  writer.append(hint(1000));
  REQUIRE(writer.flush());
  const Expected<Attempt> attempt = readAttempt(blocked / "attempts" / "a.jsonl");
  REQUIRE(attempt);
  REQUIRE(attempt->problems.size() == 1);
  CAPTURE(attempt->problems[0].text());
  const int kept = int(attempt->events.size()) - 1, missing = std::atoi(attempt->problems[0].message.c_str());
  CHECK(kept >= 31);
  CHECK(missing > 0);
  CHECK(kept + missing == 80);
  CHECK(attempt->problems[0].message.find("lines are missing here") != std::string::npos);
  CHECK(attempt->problems[0].line == std::size_t(kept) + 2);
  for (int k = 0; k < kept; ++k) CHECK(attempt->events[std::size_t(k)].t_s == double(k));
  CHECK(attempt->events.back().t_s == 1000.0);
}

TEST_CASE("names that are taken get -2 and -3, and 2 programs never write the same file") {
  const ScratchFolder scratch;
  std::vector<AttemptWriter> writers;
  for (int k = 0; k < 3; ++k) {
    writers.push_back(AttemptWriter::startNew(scratch.path, "same"));
    writers.back().append(lineOf(sampleHeader()));
    CHECK(writers.back().flush());
  }
  CHECK(writers[2].file() == scratch.path / "same-3.jsonl");
  AttemptWriter second = AttemptWriter::resume(scratch.path / "same.jsonl");
  second.append(hint(1));
  CHECK_FALSE(second.flush());
  CHECK(second.takeFault()->message == "another Moltact is writing it");
  // Nor is a file mended while it is written.
  writeFile(scratch.path / "torn.jsonl", lineOf(sampleHeader()) + "{\"kind\":\"hi");
  AttemptWriter torn = AttemptWriter::resume(scratch.path / "torn.jsonl");
  torn.append("\n");
  CHECK(torn.flush());
  CHECK(mendAttempts(scratch.path).empty());
}

TEST_CASE("an attempt that continues has its new lines after the old ones") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "a.jsonl";
  writeFile(file, sampleFile() + "{\"kind\":\"hi");
  CHECK(mendAttempts(scratch.path) == std::vector<fs::path>{file});
  {
    AttemptWriter writer = AttemptWriter::resume(file);
    writer.append(hint(77));
  }
  CHECK(bytesOf(file) == sampleFile() + hint(77));
}

}  // namespace
}  // namespace moltact
