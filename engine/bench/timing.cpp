#include "engine/bench/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/platform/preemptions.h"

namespace moltact::bench {
namespace {

using Clock = std::chrono::steady_clock;

double ns(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::nano>(to - from).count();
}

struct Contender {
  std::unique_ptr<Tracker> tracker;
  TickTimes times;
  std::vector<double> single;
  double whole_ns = 0, used_ns = 0;
  std::size_t whole_ticks = 0, ticks = 0, touching = 0;
};

void approach(Contender& c, const Stroke& stroke) {
  c.tracker->reset();
  for (const Vec3& h : stroke.approach) {
    const auto begin = Clock::now();
    const bool touching = c.tracker->step({h}).touching();
    if (touching && c.times.first_touch_s == 0) c.times.first_touch_s = 1e-9 * ns(begin, Clock::now());
  }
}

void timeWhole(Contender& c, const std::vector<Vec3>& path) {
  std::size_t touching = 0;
  const auto begin = Clock::now();
  for (const Vec3& h : path) touching += c.tracker->step({h}).touching();
  const double took = ns(begin, Clock::now());
  c.whole_ns += took;
  c.used_ns += took;
  c.whole_ticks += path.size();
  c.touching += touching;
}

void timeSingle(Contender& c, const std::vector<Vec3>& path, double clock_ns) {
  c.single.reserve(c.single.size() + path.size());
  for (const Vec3& h : path) {
    const auto begin = Clock::now();
    const bool touching = c.tracker->step({h}).touching();
    const double took = ns(begin, Clock::now());
    c.touching += touching;
    c.used_ns += took;
    c.single.push_back(std::max(0.0, took - clock_ns));
  }
}

}  // namespace

double clockCost_ns() {
  double smallest = 1e9;
  for (int k = 0; k < 20'000; ++k) {
    const auto begin = Clock::now();
    smallest = std::min(smallest, ns(begin, Clock::now()));
  }
  return smallest;
}

std::vector<TickTimes> timeMethods(std::span<const Method* const> methods,
                                   const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                   const std::vector<Stroke>& strokes, double budget_s) {
  const double clock_ns = clockCost_ns();
  const Vec3 outside = scene->high_A() + Vec3(scene->largestRadius_A() + probe_A + 10.0);
  std::vector<Contender> contenders(methods.size());
  for (std::size_t k = 0; k < methods.size(); ++k) {
    Contender& c = contenders[k];
    c.times.method = methods[k];
    const auto begin = Clock::now();
    c.tracker = methods[k]->make(scene, probe_A);
    c.tracker->step({outside});
    c.times.make_s = 1e-9 * ns(begin, Clock::now());
  }
  for (std::size_t s = 0; s < strokes.size(); ++s)
    for (Contender& c : contenders) {
      if (s >= 2 && c.used_ns > 1e9 * budget_s) continue;
      approach(c, strokes[s]);
      const std::vector<Vec3>& path = strokes[s].counted;
      const std::uint64_t preempted = preemptionsOfThisThread();
      const double whole_ns = c.whole_ns;
      const std::size_t singles = c.single.size();
      if (s % 2 == 0)
        timeWhole(c, path);
      else
        timeSingle(c, path, clock_ns);
      c.ticks += path.size();
      // The first stroke of either kind is kept in any case: a figure from a disturbed stroke is better than none.
      if (s >= 2 && preemptionsOfThisThread() != preempted) {
        if (s % 2 == 0) c.whole_ns = whole_ns, c.whole_ticks -= path.size();
        c.single.resize(singles);
        ++c.times.dropped;
      }
    }
  std::vector<TickTimes> out;
  for (Contender& c : contenders) {
    c.times.mean_ns = c.whole_ticks ? c.whole_ns / double(c.whole_ticks) : 0;
    c.times.single_ns = statisticsOf(std::move(c.single));
    c.times.touching = c.ticks ? double(c.touching) / double(c.ticks) : 0;
    c.times.memory_usage = c.tracker->memoryUsage();
    out.push_back(c.times);
  }
  return out;
}

double scenePreparation_s(const std::vector<Sphere>& spheres) {
  double smallest = 1e9, sum = 0;
  for (int k = 0; k < 3 && sum < 1; ++k) {
    std::vector<Sphere> copy = spheres;
    const auto begin = Clock::now();
    const SphereGrid scene(std::move(copy));
    const double took = 1e-9 * ns(begin, Clock::now());
    smallest = std::min(smallest, took);
    sum += took;
  }
  return smallest;
}

}  // namespace moltact::bench
