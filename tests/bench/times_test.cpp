// The clock's resolution from its readings, and the sentences about times, for synthetic figures.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/bench/clock_step.h"
#include "engine/bench/cold_cache_ticks.h"
#include "engine/bench/methods/bench_methods.h"
#include "engine/bench/tables.h"
#include "engine/bench/trade_off_sentences.h"

using namespace moltact;
using namespace moltact::bench;

namespace {

// Differences read from a clock with steps of `step_ns` whose readings are rounded to whole nanoseconds.
std::vector<double> readings(double step_ns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<long> begins(0, 1'000'000'000), lasts(1, 40);
  std::vector<double> out;
  for (int k = 0; k < 1500; ++k) {
    const long from = begins(random), to = from + lasts(random);
    out.push_back(std::round(double(to) * step_ns) - std::round(double(from) * step_ns));
  }
  return out;
}

TradeOff point(const char* method, double tick_ns, double off_A, std::size_t bytes) {
  TradeOff p{findBenchMethod(method), tick_ns, {}, {1, bytes}, false, false};
  p.accuracy.scp_A.rms = p.accuracy.scp_A.max = off_A;
  p.accuracy.direction_deg.rms = 10 * off_A;
  return p;
}

ColdCacheTimes cool(const char* method, double sleeping_ns, double thrashed_ns) {
  ColdCacheTimes c;
  c.method = findBenchMethod(method);
  c.sleeping_ns.count = c.thrashed_ns.count = 100;
  c.sleeping_ns.p50 = sleeping_ns, c.thrashed_ns.p50 = thrashed_ns;
  return c;
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

}  // namespace

TEST_CASE(
    "a clock of 26 cycles of 2.6 GHz steps by 10 ns although its readings differ by any nanosecond; one of 1 ns by 1") {
  for (const double step : {10.0, 10.4, 4.17, 25.6, 41.67, 100.0}) {
    CAPTURE(step);
    CHECK(stepOf(readings(step, 5)) == doctest::Approx(step).epsilon(0.01));
  }
  CHECK(stepOf(readings(1.0, 5)) == 1.0);
  CHECK(stepOf(readings(0.38, 5)) == 1.0);
  CHECK(stepOf({}) == 1.0);
}

TEST_CASE("the clock that ticks are timed by steps by 1 to 200 ns, and all its differences lie on that comb") {
  const double step = clockStep_ns();
  CHECK(step >= 1.0);
  CHECK(step <= 200.0);
}

TEST_CASE("the sentences name what is faster than exact with its error, and every ratio as it comes out") {
  const std::string text =
      tradeOffSentences({point("exact", 40, 1e-14, 1'000'000), point("mesh960", 80, 0.05, 2'000'000),
                         point("sasmesh05", 30, 0.06, 17'000'000)});
  CHECK(has(text, "`sasmesh05` 0.750 times; `mesh960` 2 times"));
  CHECK(has(text, "Faster than `exact`: `sasmesh05` (0.750 times its time, off by 0.0600 A)."));
  CHECK(has(text, "`mesh960` 0.0500 A and 0.500 degrees; `sasmesh05` 0.0600 A"));
  CHECK(has(text, "relative to `exact`'s 1 MB: `sasmesh05` 17 times"));
  const std::string none =
      tradeOffSentences({point("exact", 40, 1e-14, 1'000'000), point("mesh960", 80, 0.05, 2'000'000)});
  CHECK(has(none, "Faster than `exact`: none."));
  CHECK(tradeOffSentences({}).empty());
  CHECK(tradeOffSentences({point("mesh960", 80, 0.05, 1)}).empty());
}

TEST_CASE("the sentence about a hand's contacts is derived from the medians, with the share of the millisecond") {
  const std::string text = coldCacheSentences({cool("exact", 160, 3100), cool("mesh960", 311, 3800)});
  CHECK(has(text, "a tick of `exact` takes 160 ns."));
  CHECK(has(text, "3.10 us"));
  CHECK(has(text, "0.310 % of the millisecond"));
  CHECK(has(text, "`mesh960`, then takes 3.80 us"));
  CHECK(coldCacheSentences({}).empty());
}

TEST_CASE("of 3 methods 20 ticks with sleep between and 4 after lost caches are all in contact, and a row each") {
  const auto scene = std::make_shared<const SphereGrid>(madeScenes(true, 1)[0].makeSpheres());
  const std::vector<const Method*> methods{findMethod("exact"), findMethod("mesh960"), findBenchMethod("sasmesh05")};
  StrokePlan plan;
  plan.strokes = 2, plan.ticks = 50;
  const auto times =
      timeColdCache(methods, scene, kWaterProbe_A, contactStrokes(scene, kWaterProbe_A, plan), {20, 4}, {});
  REQUIRE(times.size() == 3);
  for (const ColdCacheTimes& t : times) {
    CHECK(t.sleeping_ns.count == 20);
    CHECK(t.thrashed_ns.count == 4);
    CHECK(t.touching == 1.0);
  }
  const ReportTable table = coldCacheTable(times, {}, 50);
  CHECK(table.rows.size() == 3);
  CHECK(std::get<double>(table.rows[0][7]) == 1.0);  // exact beside itself
  CHECK(has(table.note, "The clock has a step of"));
}

TEST_CASE("a method that prepares the whole scene is left out of scenes beyond its size limit") {
  const std::vector<const Method*> methods{findMethod("exact"), findBenchMethod("sasmesh05")};
  CHECK(methodsForSize(methods, 20'000).size() == 2);
  CHECK(methodsForSize(methods, 20'001).size() == 1);
  CHECK(methodsForSize(methods, 50, 13'751).size() == 1);
}

TEST_CASE("the page of speed has a place for each table and each paragraph that a run writes") {
  std::ifstream in(std::filesystem::path(MOLTACT_SOURCE_DIR) / "docs/speed-and-accuracy.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  for (const std::string name : {"trade_off", "trade_off_sentences", "beside_paper", "ticks_13800", "ticks_exact",
                                 "cool", "cool_sentences", "ready_13800", "ready_exact", "size_sentences"}) {
    CAPTURE(name);
    CHECK(has(page, "<!-- " + name + ":begin "));
    CHECK(has(page, "<!-- " + name + ":end -->"));
  }
}
