// Numbers that the program never writes. Oracle: every number of a sample attempt in turn, found by traversing its
// JSON.
#include "engine/results/attempt_ranges.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/results/attempt_file.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_page.h"
#include "engine/results/page_parts.h"
#include "engine/results/timeline.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

using Json = nlohmann::ordered_json;

// Calls take(line with one of its numbers replaced, key) for every number of the line.
void withEachNumber(const std::string& line, double by,
                    const std::function<void(const std::string&, const std::string&)>& take) {
  Json json = Json::parse(line);
  const std::function<void(Json&, const std::string&)> walk = [&](Json& at, const std::string& key) {
    if (at.is_number()) {
      const Json before = at;
      at = by;
      std::string text = json.dump();
      take(text + '\n', key);
      at = before;
    } else if (at.is_object()) {
      for (auto& [name, value] : at.items()) walk(value, name);
    } else if (at.is_array()) {
      for (auto& value : at) walk(value, key);
    }
  };
  walk(json, "");
}

TEST_CASE(
    "each number of each kind of line, made 1.7e308, -1e300 or 1e37, gets its line passed over and "
    "reported; in range it does not") {
  std::size_t numbers = 0;
  for (const AttemptEvent& event : sampleEvents())
    for (const double by : {1.7e308, -1e300, 1e37})
      withEachNumber(lineOf(event), by, [&](const std::string& line, const std::string& key) {
        CAPTURE(line);
        CHECK_MESSAGE(attemptRange(key) != nullptr, key);
        const auto read = readEventLine(line);
        if (bool(read) && !key.empty())
          CHECK(false);
        else
          CHECK(read.problem().message.find("'" + key + "'") != std::string::npos);
        ++numbers;
      });
  MESSAGE(numbers << " lines");
  CHECK(numbers > 300);
  for (const AttemptEvent& event : sampleEvents()) CHECK(bool(readEventLine(lineOf(event))));
}

TEST_CASE("a turn that is none and an orientation of length 0 are passed over") {
  std::string stage = lineOf(sampleEvents()[1]);
  const std::size_t at = stage.find("\"turn\":[1.0");
  REQUIRE(at != std::string::npos);
  std::string mirrored = stage;
  mirrored.replace(at, 11, "\"turn\":[-1.0");
  CHECK(readEventLine(mirrored).problem().message == "'turn' is no rotation");
  stage.replace(at, 11, "\"turn\":[0.5");
  CHECK(readEventLine(stage).problem().message == "'turn' is no rotation");
  CHECK(readEventLine(R"({"kind":"view","t":1,"orientation":[0,0,0,0],"target_A":[0,0,0],"distance_A":5})")
            .problem()
            .message == "'orientation' is no rotation");
}

TEST_CASE("lists longer than Moltact writes are passed over: 257 atoms, 101 figures, 10 001 values, 10 001 steps") {
  Json done = Json::parse(lineOf({1.0, TaskDone{"a", 0, 1.0, InputKind::Mouse, {{"f", 1.0, "N"}}}}));
  Json curve = Json::parse(lineOf({1.0, CurveKept{"a", 0, true, "depth", 1.0, 1.0, {0.0}}}));
  Json touch = Json::parse(lineOf({1.0, TouchBegan{{1}}}));
  const auto grown = [](Json& list, std::size_t to) {
    const Json one = list[0];
    while (list.size() < to) list.push_back(one);
  };
  grown(done["figures"], kMaxFigures);
  CHECK(bool(readEventLine(done.dump())));
  grown(done["figures"], kMaxFigures + 1);
  CHECK_FALSE(bool(readEventLine(done.dump())));
  grown(curve["force_N"], kMaxCurveValues + 1);
  CHECK_FALSE(bool(readEventLine(curve.dump())));
  grown(touch["atoms"], kMaxTouched + 1);
  CHECK_FALSE(bool(readEventLine(touch.dump())));
  Json header = Json::parse(lineOf(sampleHeader()));
  grown(header["lesson"]["steps"], kMaxSteps + 1);
  CHECK_FALSE(bool(readHeaderLine(header.dump())));
}

TEST_CASE("a class with an attempt of every such number has its report, which names each line that was passed over") {
  const ScratchFolder scratch;
  std::string bytes = lineOf(sampleHeader());
  std::size_t bad = 0;
  for (const AttemptEvent& event : sampleEvents()) {
    bytes += lineOf(event);
    withEachNumber(lineOf(event), 1.7e308, [&](const std::string& line, const std::string&) {
      bytes += line;
      ++bad;
    });
  }
  const auto file = scratch.path / "a.jsonl";
  writeFile(file, bytes);
  Expected<Attempt> all = readAttempt(file), some = readAttempt(file, ReadDepth::NoHipSamples);
  REQUIRE((bool(all) && bool(some)));
  CHECK(all->problems.size() == bad);
  CHECK(all->events.size() == sampleEvents().size());
  const std::vector<Problem> problems = some->problems;
  const ClassSummary summary = summarise({*std::move(some)});
  CHECK(classPage(summary, problems, "").size() < 400'000);
  CHECK(classCsv(summary).size() < 4000);
  const Timeline line(*std::move(all));
  CHECK(line.length_s() == 9.5);
}

TEST_CASE("scales, strips and histograms are drawn for every number there is, in less than 20 kB each") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double most :
       {0.0, -1.0, 5e-324, 1e-300, 1e-12, 1e-3, 1.0, 7.3, 1e10, 1e37, 1e300, 1.7e308, inf, -inf, std::nan("")}) {
    CAPTURE(most);
    const double top = page::roundAbove(most);
    CHECK(std::isfinite(top));
    CHECK(top > 0.0);
    CHECK(page::stripScale(most, "N").size() < 20'000);
    CHECK(page::stripScale(top, "N").size() < 20'000);
    CHECK(page::strip({{most, InputKind::Mouse}, {1.0, InputKind::Device}}, top).size() < 20'000);
    for (const double other : {0.0, 1.0, most})
      CHECK(page::histogram("t", "N", {{most, InputKind::Mouse}, {other, InputKind::Device}}).size() < 20'000);
  }
  CHECK(page::roundAbove(7.3) == doctest::Approx(8.0));
}

}  // namespace
}  // namespace moltact
