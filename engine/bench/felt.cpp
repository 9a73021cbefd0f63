#include "engine/bench/felt.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/bench/accuracy.h"
#include "engine/bench/touch_thresholds.h"
#include "engine/haptics/exact/exact_tracker.h"

namespace moltact::bench {
namespace {

constexpr double kTicks_per_s = 1000;
constexpr double kNeverFraction = 0.001, kOftenFraction = 0.05;  // fractions of ticks called "never" and "often"
constexpr double kNeverSteps_per_s = 0.1;

}  // namespace

FeltErrors feltOn(const std::string& where, const Method& method, const std::shared_ptr<const SphereGrid>& scene,
                  double probe_A, const std::vector<Stroke>& strokes, const LoopSettings& loop) {
  FeltErrors out;
  out.where = where;
  out.method = &method;
  ExactTracker exact(scene, probe_A);
  const auto tracker = method.make(scene, probe_A);
  std::vector<double> direction;
  std::size_t seen = 0, blind = 0, size = 0, size_wide = 0, steps = 0, steps_wide = 0, off = 0, lost = 0;
  const auto force = [&](const Contact& c) { return springForce(loop, c, loop.device.max_force_N).N; };
  for (const Stroke& stroke : strokes) {
    exact.reset();
    tracker->reset();
    for (const Vec3& h : stroke.approach) exact.step({h}), tracker->step({h});
    std::vector<Vec3> felt, right;
    std::vector<bool> touching;
    for (const Vec3& h : stroke.counted) {
      const Contact e = exact.step({h}), c = tracker->step({h});
      right.push_back(force(e));
      felt.push_back(force(c));
      touching.push_back(e.touching());
      if (!e.touching()) continue;
      ++out.ticks;
      lost += !c.touching();
      off += glm::distance(c.touching() ? c.scp.A : h, e.scp.A) > kPlaceFelt_A;
      const double true_N = glm::length(right.back());
      if (c.touching()) direction.push_back(angle_deg(felt.back(), right.back()));
      const double differs = std::abs(glm::length(felt.back()) - true_N) / std::max(true_N, kMinForce_N);
      size += differs > kForceWeber;
      size_wide += differs > kForceWeberWide;
    }
    for (std::size_t k = 1; k < felt.size(); ++k) {
      if (!touching[k] && !touching[k - 1]) continue;
      double true_step = 0;
      for (std::size_t j = std::max<std::size_t>(k, 3) - 2; j <= std::min(k + 2, felt.size() - 1); ++j)
        true_step = std::max(true_step, glm::distance(right[j], right[j - 1]));
      const double smallest = std::max({glm::length(felt[k]), glm::length(felt[k - 1]), kMinForce_N});
      const double step = (glm::distance(felt[k], felt[k - 1]) - true_step) / smallest;
      steps += step > kForceWeber;
      steps_wide += step > kForceWeberWide;
    }
  }
  for (const double angle : direction) seen += angle > kDirectionSeen_deg, blind += angle > kDirectionBlind_deg;
  const double n = double(std::max<std::size_t>(out.ticks, 1));
  out.direction_deg = statisticsOf(std::move(direction));
  out.direction_seen = double(seen) / n, out.direction_blind = double(blind) / n;
  out.size = double(size) / n, out.size_wide = double(size_wide) / n;
  out.steps = kTicks_per_s * double(steps) / n, out.steps_wide = kTicks_per_s * double(steps_wide) / n;
  out.off = double(off) / n, out.lost = double(lost) / n;
  return out;
}

FeltErrors together(const std::string& where, const std::vector<FeltErrors>& parts) {
  FeltErrors out;
  out.where = where;
  for (const FeltErrors& p : parts) {
    out.method = p.method;
    const double before = double(out.ticks), now = double(p.ticks), all = std::max(before + now, 1.0);
    const auto mix = [&](double& a, double b) { a = (a * before + b * now) / all; };
    mix(out.direction_seen, p.direction_seen), mix(out.direction_blind, p.direction_blind);
    mix(out.size, p.size), mix(out.size_wide, p.size_wide), mix(out.steps, p.steps), mix(out.steps_wide, p.steps_wide);
    mix(out.off, p.off), mix(out.lost, p.lost);
    mix(out.direction_deg.p50, p.direction_deg.p50), mix(out.direction_deg.p99, p.direction_deg.p99);
    out.direction_deg.max = std::max(out.direction_deg.max, p.direction_deg.max);
    out.ticks += p.ticks;
  }
  return out;
}

ReportTable feltTable(std::string name, std::string title, const std::vector<FeltErrors>& rows,
                      const std::vector<double>& ns) {
  ReportTable t{std::move(name), std::move(title), {{"method", "method"}}, {}, ""};
  if (!ns.empty()) t.columns.push_back({"tick_ns", "tick (ns)"});
  for (const Column& c :
       std::vector<Column>{{"direction_p50_deg", "direction, median (deg)"},
                           {"direction_p99_deg", "p99 (deg)"},
                           {"direction_seen_percent", "over " + constant(kDirectionSeen_deg) + " deg (%)"},
                           {"direction_blind_percent", "over " + constant(kDirectionBlind_deg) + " deg (%)"},
                           {"size_percent", "size off by over " + constant(100 * kForceWeber) + " % (%)"},
                           {"size_wide_percent", "over " + constant(100 * kForceWeberWide) + " % (%)"},
                           {"steps_per_s", "steps over " + constant(100 * kForceWeber) + " % (1/s)"},
                           {"steps_wide_per_s", "over " + constant(100 * kForceWeberWide) + " % (1/s)"},
                           {"off_percent", "place off (%)"},
                           {"lost_percent", "contact lost (%)"}})
    t.columns.push_back(c);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const FeltErrors& f = rows[k];
    std::vector<Cell> row{std::string(f.method->name)};
    if (!ns.empty()) row.push_back(k < ns.size() && ns[k] > 0 ? Cell{ns[k]} : Cell{});
    for (const double value :
         {f.direction_deg.p50, f.direction_deg.p99, 100 * f.direction_seen, 100 * f.direction_blind, 100 * f.size,
          100 * f.size_wide, f.steps, f.steps_wide, 100 * f.off, 100 * f.lost})
      row.push_back(value);
    t.rows.push_back(std::move(row));
  }
  t.note =
      "Compared with exact in the same tick, over the ticks in which exact touches. Shares are percent of ticks. "
      "Steps are counted per second of touch, if they exceed those of exact within two ticks by more than this share "
      "of the force. Place off: over " +
      constant(kPlaceFelt_A) + " A.";
  return t;
}

std::string feltSentences(const std::vector<FeltErrors>& rows) {
  const auto sorted = [&](const char* what, const std::function<double(const FeltErrors&)>& of, double never,
                          double often, const char* unit, double times) {
    std::vector<std::string> no, at_times, yes;
    for (const FeltErrors& f : rows) {
      if (isReference(*f.method)) continue;
      const double value = of(f);
      const std::string name = "`" + std::string(f.method->name) + "`";
      (value <= never   ? no
       : value <= often ? at_times
                        : yes)
          .push_back(value <= never ? name : name + " (" + readable(times * value) + unit + ")");
    }
    std::string out = std::string("* ") + what + ": ";
    out += no.empty() ? "no method is below the threshold throughout" : "cannot be felt with " + listed(no);
    if (!at_times.empty()) out += ". It is sometimes felt with " + listed(at_times);
    if (!yes.empty()) out += ". It is often felt with " + listed(yes);
    return out + ".\n";
  };
  return sorted(
             "A wrong direction, in the dark", [](const FeltErrors& f) { return f.direction_blind; }, kNeverFraction,
             kOftenFraction, " %", 100) +
         sorted(
             "A wrong direction, with a picture", [](const FeltErrors& f) { return f.direction_seen; }, kNeverFraction,
             kOftenFraction, " %", 100) +
         sorted(
             "A wrong size, by 10 %", [](const FeltErrors& f) { return f.size_wide; }, kNeverFraction, kOftenFraction,
             " %", 100) +
         sorted(
             "A step of 10 %", [](const FeltErrors& f) { return f.steps_wide; }, kNeverSteps_per_s, 1.0, "/s", 1) +
         "\nThe figures are percent of ticks, or steps per second. *Cannot* means in at most " +
         constant(100 * kNeverFraction) + " % of ticks, or at most " + constant(kNeverSteps_per_s) +
         " times per second. *Often* means in more than " + constant(100 * kOftenFraction) +
         " % of ticks, or more than once per second.\n";
}

}  // namespace moltact::bench
