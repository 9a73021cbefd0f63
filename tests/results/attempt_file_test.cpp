// Oracle: the lines of a file as they were before it was damaged.
#include <doctest/doctest.h>

#include <algorithm>

#include "engine/results/attempt_file.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

TEST_CASE("a file cut off at any byte gives every line that ends before the cut, and mending loses none of them") {
  const ScratchFolder scratch;
  const std::string whole = sampleFile();
  const fs::path file = scratch.path / "a.jsonl";
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    CAPTURE(cut);
    writeFile(file, whole.substr(0, cut));
    const auto lines = static_cast<std::size_t>(std::count(whole.begin(), whole.begin() + std::ptrdiff_t(cut), '\n'));
    // A line that lacks its line end only is whole as well.
    const std::size_t good = lines + (cut < whole.size() && whole[cut] == '\n');
    const Expected<Attempt> before = readAttempt(file);
    REQUIRE(bool(before) == (good > 0));
    if (good > 0) {
      REQUIRE(before->events.size() == good - 1);
      REQUIRE(before->problems.empty());
      REQUIRE(before->torn == (cut > 0 && whole[cut - 1] != '\n' && good == lines));
    }
    mendAttempts(scratch.path);
    REQUIRE(fs::exists(file) == (good > 0));
    if (good == 0) continue;
    const std::string mended = bytesOf(file);
    REQUIRE(mended.ends_with('\n'));
    REQUIRE(whole.starts_with(mended));
    REQUIRE(static_cast<std::size_t>(std::count(mended.begin(), mended.end(), '\n')) == good);
  }
}

TEST_CASE("garbage in the middle is passed over and told with its line; what stands around it is read") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "a.jsonl";
  std::string bytes = sampleFile();
  const std::size_t third = bytes.find('\n', bytes.find('\n') + 1) + 1;
  bytes.insert(third, std::string(1, '\0') + "\xff garbage\n{\"kind\":\"hint\",\"t\":1}\n\n");
  writeFile(file, bytes);
  const Expected<Attempt> read = readAttempt(file);
  REQUIRE(bool(read));
  CHECK(read->events.size() == sampleEvents().size());
  REQUIRE(read->problems.size() == 2);
  CHECK(read->problems[0].line == 3);
  CHECK(read->problems[1].text() == file.string() + ":4: 'step' is missing; the line is passed over");
  CHECK(mendAttempts(scratch.path).empty());
  CHECK(bytesOf(file) == bytes);
}

TEST_CASE("files that are no attempts are told and stay as they are, torn or not") {
  const ScratchFolder scratch;
  for (const std::string bytes : {"{\"kind\":\"other\"}", "hello", "\n", "{\"a\":1}\n{\"b\""}) {
    const fs::path file = scratch.path / "other.jsonl";
    writeFile(file, bytes);
    CHECK_FALSE(bool(readAttempt(file)));
    CHECK(mendAttempts(scratch.path).empty());
    CHECK(bytesOf(file) == bytes);
  }
  CHECK_FALSE(bool(readAttempt(scratch.path)));
  CHECK_FALSE(bool(readAttempt(scratch.path / "none.jsonl")));
  CHECK_FALSE(bool(attemptFiles(scratch.path / "none")));
  CHECK(mendAttempts(scratch.path / "none").empty());
}

TEST_CASE("line ends of another system, and reading without the trace") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "a.jsonl";
  std::string bytes;
  for (const char c : sampleFile()) bytes += c == '\n' ? "\r\n" : std::string(1, c);
  writeFile(file, bytes);
  const Expected<Attempt> all = readAttempt(file), without = readAttempt(file, ReadDepth::NoTrace);
  REQUIRE((bool(all) && bool(without)));
  CHECK(all->problems.empty());
  CHECK(all->events.size() == sampleEvents().size());
  CHECK(without->events.size() == sampleEvents().size() - 2);
  CHECK(all->end_s() == 9.5);
}

}  // namespace
}  // namespace moltact
