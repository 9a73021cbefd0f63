// Oracle: the lines of a file before it was damaged.
#include "engine/results/attempt_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/results/attempt_writer.h"
#include "engine/results/progress.h"
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

// The same attempt as other programs write JSON: with blanks after the signs, with blanks everywhere, with sorted keys.
std::vector<std::string> respaced(const std::string& lines) {
  std::string loose, wide, sorted;
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = lines.find('\n', at);
    const auto json = nlohmann::ordered_json::parse(lines.substr(at, end - at));
    std::string text = json.dump(1);  // line ends stand between signs only
    std::erase(text, '\n');
    loose += text + '\n';
    std::string indented = json.dump(2, '\t');
    std::erase(indented, '\n');
    wide += "\t" + indented + " \n";
    sorted += nlohmann::json(json).dump() + '\n';
    at = end + 1;
  }
  return {loose, wide, sorted};
}

TEST_CASE(
    "an attempt whose lines have other blanks or another order of keys is read, mended and gone on with like our own") {
  for (const std::string& whole : respaced(sampleFile())) {
    CAPTURE(whole.substr(0, 60));
    const ScratchFolder scratch;
    const fs::path file = scratch.path / "a.jsonl";
    writeFile(file, whole);
    const Expected<Attempt> read = readAttempt(file);
    REQUIRE(bool(read));
    CHECK(read->events.size() == sampleEvents().size());
    CHECK(readAttempt(file, ReadDepth::NoHipSamples)->events.size() == sampleEvents().size() - 2);
    const auto progress = readProgress(scratch.path);
    REQUIRE(progress.size() == 1);
    CHECK(progress[0].done == 3);
    const std::size_t first = whole.find('\n') + 1, last = whole.rfind('\n', whole.size() - 2) + 1;
    for (const std::size_t cut : {whole.size() - 1, whole.size() - 5, last + 1, first + 20, first - 1}) {
      CAPTURE(cut);
      writeFile(file, whole.substr(0, cut));
      mendAttempts(scratch.path);
      const std::string mended = bytesOf(file);
      CHECK(mended.ends_with('\n'));
      CHECK((whole.starts_with(mended) || mended == whole.substr(0, cut) + '\n'));
      CHECK(readAttempt(file)->problems.empty());
    }
  }
}

TEST_CASE("whatever a file ends with, what continues with it begins a line of its own") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "a.jsonl";
  const std::string hint = lineOf({60.0, HintOpened{"one"}});
  std::vector<std::string> begins{sampleFile(), "no attempt", "{\"x\":1}\n{\"y", "\n\n \t"};
  for (const std::string& spaced : respaced(sampleFile())) begins.push_back(spaced.substr(0, spaced.size() - 9));
  for (const std::string& before : begins) {
    CAPTURE(before);
    writeFile(file, before);
    {
      AttemptWriter writer = AttemptWriter::resume(file);
      writer.append(hint);
      CHECK(writer.flush());
    }
    const std::string now = bytesOf(file);
    CHECK(now.ends_with("\n" + hint));
  }
}

TEST_CASE("garbage in the middle is passed over and reported with its line; what stands around it is read") {
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

TEST_CASE("files that are no attempts are reported and stay as they are, torn or not") {
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

TEST_CASE("line ends of another system, and reading without the HIP samples") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "a.jsonl";
  std::string bytes;
  for (const char c : sampleFile()) bytes += c == '\n' ? "\r\n" : std::string(1, c);
  writeFile(file, bytes);
  const Expected<Attempt> all = readAttempt(file), without = readAttempt(file, ReadDepth::NoHipSamples);
  REQUIRE((bool(all) && bool(without)));
  CHECK(all->problems.empty());
  CHECK(all->events.size() == sampleEvents().size());
  CHECK(without->events.size() == sampleEvents().size() - 2);
  CHECK(all->end_s() == 9.5);
}

}  // namespace
}  // namespace moltact
