// `moltact report` as a process: its output, its messages about broken files, and its exit status.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>

#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct Ended {
  int status = -1;
  std::string said;
};

Ended report(const std::string& arguments) {
  Ended out;
  FILE* pipe = ::popen((std::string(MOLTACT_BINARY) + " report " + arguments + " 2>&1").c_str(), "r");
  REQUIRE(pipe);
  std::array<char, 512> part;
  while (std::fgets(part.data(), int(part.size()), pipe)) out.said += part.data();
  out.status = WEXITSTATUS(::pclose(pipe));
  return out;
}

TEST_CASE(
    "a folder with 2 attempts, one of them damaged, and 2 files that are none gives both reports and names what was "
    "passed over") {
  const ScratchFolder scratch;
  const fs::path results = scratch.path / "results", csv = scratch.path / "class.csv",
                 html = scratch.path / "class.html";
  fs::create_directory(results);
  writeFile(results / "a.jsonl", sampleFile());
  std::string damaged = sampleFile();
  damaged.insert(damaged.find('\n') + 1, "what?\n");
  writeFile(results / "b.jsonl", damaged + "{\"kind\":\"hi");
  writeFile(results / "c.jsonl", "not this\n");
  writeFile(results / "d.jsonl", "");
  writeFile(results / "e.txt", "nor this");
  const Ended ended = report(results.string() + " --csv " + csv.string() + " --html " + html.string());
  CHECK(ended.status == 0);
  for (const char* part : {"b.jsonl:2: it is no JSON object", "c.jsonl:1: it is no attempt at a lesson",
                           "d.jsonl: it is empty", "1 student, 1 lesson, 2 attempts"})
    CHECK_MESSAGE(ended.said.find(part) != std::string::npos, ended.said);
  CHECK(ended.said.find("e.txt") == std::string::npos);
  CHECK(bytesOf(csv).starts_with("\xEF\xBB\xBFstudent,lesson,"));
  CHECK(bytesOf(html).find("b.jsonl:2") != std::string::npos);
}

TEST_CASE(
    "without names the page does not name a student whose name is that of a folder with a damaged file, and "
    "--typed-texts "
    "alone is refused") {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path / "results" / "Visible");
  std::string damaged = sampleFile();
  damaged.insert(damaged.find('\n') + 1, "what?\n");
  writeFile(scratch.path / "results" / "Visible" / "a.jsonl", damaged);
  writeFile(scratch.path / "results" / "Visible" / "b.jsonl", "not this\n");
  const std::string results = (scratch.path / "results").string();
  const fs::path html = scratch.path / "class.html";
  const Ended ended = report(results + " --anonymous --html " + html.string());
  CHECK(ended.status == 0);
  CHECK(ended.said.find("Visible/a.jsonl:2") != std::string::npos);
  const std::string page = bytesOf(html);
  CHECK(page.find("Visible") == std::string::npos);
  CHECK(page.find("file 1:2: it is no JSON object") != std::string::npos);
  CHECK(page.find("file 2:1: it is no attempt") != std::string::npos);
  const Ended refused = report(results + " --typed-texts --html " + html.string());
  CHECK(refused.status == 2);
  CHECK(refused.said.find("--anonymous or --code-word") != std::string::npos);
}

TEST_CASE("without attempts, without a place to write, or with a full disk the command says so and fails") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "a.jsonl", sampleFile());
  const std::string good = (scratch.path / "a.jsonl").string();
  CHECK(report((scratch.path / "none").string() + " --csv /dev/null").status == 1);
  CHECK(report(good).status == 2);
  CHECK(report("--csv /dev/null").status == 2);
  const Ended full = report(good + " --csv /dev/full");
  CHECK(full.status == 1);
  CHECK(full.said.find("the disk is full; free some space on it") != std::string::npos);
  CHECK(report(good + " --html " + (scratch.path / "no" / "folder.html").string()).status == 1);
}

}  // namespace
}  // namespace moltact
