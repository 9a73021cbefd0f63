#include "engine/bench/cold_cache_ticks.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/bench/clock_step.h"

namespace moltact::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kTurns = 4;        // per method
constexpr std::size_t kLine_bytes = 64;  // a cache line, or a part of one

// The state of a method along the strokes.
struct Walker {
  std::unique_ptr<Tracker> tracker;
  std::size_t stroke = 0, tick = 0;

  const Vec3& next(const std::vector<Stroke>& strokes) {
    if (tick == strokes[stroke].counted.size()) stroke = (stroke + 1) % strokes.size(), tick = 0;
    if (tick == 0) {
      tracker->reset();
      for (const Vec3& h : strokes[stroke].approach) tracker->step({h});
    }
    return strokes[stroke].counted[tick++];
  }
};

}  // namespace

std::vector<ColdCacheTimes> timeColdCache(std::span<const Method* const> methods,
                                          const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                          const std::vector<Stroke>& strokes, const ColdCachePlan& plan,
                                          const Progress& progress) {
  const double clock_ns = clockCost_ns();
  std::vector<ColdCacheTimes> out(methods.size());
  std::vector<Walker> walkers(methods.size());
  std::vector<std::vector<double>> sleeping(methods.size()), thrashed(methods.size());
  const Vec3 outside = scene->high_A() + Vec3(scene->largestRadius_A() + probe_A + 10.0);
  for (std::size_t k = 0; k < methods.size(); ++k) {
    out[k].method = methods[k];
    walkers[k].tracker = methods[k]->make(scene, probe_A);
    walkers[k].tracker->step({outside});
  }
  std::vector<unsigned char> other(kThrashed_bytes);
  std::size_t touching = 0;
  const auto timed = [&](Walker& w, const Vec3& h) {
    const auto begin = Clock::now();
    touching += w.tracker->step({h}).touching();
    return std::max(0.0, std::chrono::duration<double, std::nano>(Clock::now() - begin).count() - clock_ns);
  };
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    for (std::size_t k = 0; k < methods.size(); ++k) {
      if (progress) progress((double(turn) + double(k) / double(methods.size())) / double(kTurns), methods[k]->name);
      Walker& w = walkers[k];
      touching = 0;
      auto next = Clock::now();
      for (std::size_t n = 0; n < plan.sleeping_ticks / kTurns; ++n) {
        const Vec3& h = w.next(strokes);
        std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
        sleeping[k].push_back(timed(w, h));
      }
      for (std::size_t n = 0; n < plan.thrashed_ticks / kTurns; ++n) {
        const Vec3& h = w.next(strokes);
        for (std::size_t at = 0; at < other.size(); at += kLine_bytes) ++other[at];
        thrashed[k].push_back(timed(w, h));
      }
      out[k].touching += double(touching);
    }
  for (std::size_t k = 0; k < methods.size(); ++k) {
    out[k].touching /= std::max(1.0, double(sleeping[k].size() + thrashed[k].size()));
    out[k].sleeping_ns = statisticsOf(std::move(sleeping[k]));
    out[k].thrashed_ns = statisticsOf(std::move(thrashed[k]));
  }
  if (progress) progress(1, "");
  return out;
}

ReportTable coldCacheTable(const std::vector<ColdCacheTimes>& cool, const std::vector<TickTimes>& hot,
                           std::size_t spheres) {
  ReportTable t{"cool",
                "One tick per millisecond, in contact on " + readable(double(spheres)) + " spheres",
                {{"method", "method"},
                 {"row_mean_ns", "in a row: mean (ns)"},
                 {"sleeping_p50_ns", "each ms: p50 (ns)"},
                 {"sleeping_p99_ns", "p99 (ns)"},
                 {"sleeping_max_ns", "max (ns)"},
                 {"thrashed_p50_ns", "caches lost: p50 (ns)"},
                 {"thrashed_p99_ns", "p99 (ns)"},
                 {"sleeping_times_exact", "each ms / exact"},
                 {"thrashed_times_exact", "caches lost / exact"},
                 {"touching_percent", "touching (%)"}},
                {},
                ""};
  const auto ratio = [](double a, double b) { return b > 0 ? Cell{a / b} : Cell{}; };
  const ColdCacheTimes* exact = nullptr;
  for (const ColdCacheTimes& c : cool)
    if (isReference(*c.method)) exact = &c;
  for (const ColdCacheTimes& c : cool) {
    const auto beside =
        std::find_if(hot.begin(), hot.end(), [&](const TickTimes& row) { return row.method == c.method; });
    t.rows.push_back({std::string(c.method->name), beside == hot.end() ? Cell{} : Cell{beside->mean_ns},
                      c.sleeping_ns.p50, c.sleeping_ns.p99, c.sleeping_ns.max, c.thrashed_ns.p50, c.thrashed_ns.p99,
                      ratio(c.sleeping_ns.p50, exact ? exact->sleeping_ns.p50 : 0),
                      ratio(c.thrashed_ns.p50, exact ? exact->thrashed_ns.p50 : 0), 100 * c.touching});
  }
  t.note = "Each ms: " + readable(cool.empty() ? 0 : double(cool.front().sleeping_ns.count)) +
           " ticks of each method, one per millisecond, with the thread asleep in between. Caches lost: " +
           readable(cool.empty() ? 0 : double(cool.front().thrashed_ns.count)) +
           " ticks, each after reading and writing " + readable(double(kThrashed_bytes >> 20)) +
           " MiB of other memory. The clock has a step of " + readable(clockStep_ns()) + " ns.";
  return t;
}

}  // namespace moltact::bench
