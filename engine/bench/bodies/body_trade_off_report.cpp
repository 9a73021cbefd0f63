// Table, sentences and chart of body_trade_off.h.
#include <algorithm>
#include <map>

#include "engine/bench/bodies/body_trade_off.h"
#include "engine/bench/chart_svg.h"

namespace moltact::bench {
namespace {

constexpr double kRounding = 1e-13;  // smaller errors have no mark

std::string quoted(const BodyMethod& m) { return "`" + std::string(m.name) + "`"; }

Mark markOf(const BodyMethod& method) { return markAt(std::size_t(&method - bodyMethods().data())); }

// One point per body and method.
template <class Error>
ChartPanel errorPanel(const std::vector<BodyTradeOff>& points, std::string title, std::string y_axis, Error error) {
  ChartPanel panel{std::move(title), "mean time of one tick, in loops of 1000 sphere distances", std::move(y_axis), {}};
  for (const BodyTradeOff& p : points) {
    auto series = std::find_if(panel.series.begin(), panel.series.end(),
                               [&](const ChartSeries& s) { return s.name == p.method->name; });
    if (series == panel.series.end())
      series = panel.series.insert(series,
                                   ChartSeries{std::string(p.method->name), markOf(*p.method), false, false, true, {}});
    const double off = error(p);
    series->points.push_back({p.meanLoops(), off > kRounding ? off : 0.0, std::to_string(p.atoms)});
  }
  return panel;
}

}  // namespace

ReportTable bodyTradeOffTable(const std::vector<BodyTradeOff>& points, const BodyTradeOffOptions& options) {
  ReportTable t{"body_trade_off",
                "Rigid bodies: speed against accuracy",
                {{"atoms", "atoms"},
                 {"scene", "scene"},
                 {"method", "method"},
                 {"mean_loops", "mean / loop"},
                 {"p999_loops", "p99.9 / loop"},
                 {"mean_ns", "mean (ns)"},
                 {"position_rms_A", "position, rms (A)"},
                 {"turn_rms_rad", "orientation, rms (rad)"},
                 {"force_rms_N", "force, rms (N)"},
                 {"torque_rms_NA", "torque, rms (N A)"},
                 {"overlap_rms_A", "overlap, rms (A)"},
                 {"overlap_max_A", "max (A)"},
                 {"position_p50_A", "position, median (A)"},
                 {"force_p50_N", "force, median (N)"},
                 {"right_force_N", "right force, mean (N)"},
                 {"right_torque_NA", "right torque, mean (N A)"},
                 {"judged", "ticks judged"},
                 {"unconfirmed", "unconfirmed"}},
                {},
                ""};
  t.note =
      "Each body is pressed 6 A deep into its scene, dragged and twisted, in " + readable(double(options.ticks)) +
      " ticks. A tick's time is the minimum of " + std::to_string(options.runs) +
      " runs; the loop of 1000 sphere distances takes " + readable(points.empty() ? 0 : points.front().loop_ns / 1000) +
      " us in the same process. Errors are those of every " +
      (options.judge_every == 1 ? "" : std::to_string(options.judge_every) + "th ") +
      "tick in contact, against the rest that the oracle over all pairs confirms and finds to 1e-15 A. The springs "
      "have 1 N per A at the middle and (radius of gyration)^2 N A per rad. Unconfirmed ticks are not judged.";
  for (const BodyTradeOff& p : points)
    t.rows.push_back({double(p.atoms), double(p.scene_spheres), std::string(p.method->name), p.meanLoops(),
                      p.p999Loops(), p.mean_ns, p.position_A.rms, p.turn_rad.rms, p.force_N.rms, p.torque_NA.rms,
                      p.overlap_A.rms, p.overlap_A.max, p.position_A.p50, p.force_N.p50, p.right_force_N,
                      p.right_torque_NA, double(p.judged), double(p.unconfirmed)});
  return t;
}

std::string bodyTradeOffSentences(const std::vector<BodyTradeOff>& points) {
  std::string out;
  for (const BodyMethod& m : bodyMethods()) {
    std::vector<BodyTradeOff> own;
    for (const BodyTradeOff& p : points)
      if (p.method == &m) own.push_back(p);
    if (own.empty()) continue;
    const auto range = [&](auto value) {
      double low = 1e300, high = 0;
      for (const BodyTradeOff& p : own) low = std::min(low, value(p)), high = std::max(high, value(p));
      return low == high ? readable(high) : readable(low) + " to " + readable(high);
    };
    out += "* " + quoted(m) + ": a tick takes " + range([](const auto& p) { return p.meanLoops(); }) +
           " loops in the mean and " + range([](const auto& p) { return p.p999Loops(); }) +
           " at the 99.9th percentile. The rms errors are " + range([](const auto& p) { return p.position_A.rms; }) +
           " A, " + range([](const auto& p) { return p.turn_rad.rms; }) + " rad, " +
           range([](const auto& p) { return p.force_N.rms; }) + " N and " +
           range([](const auto& p) { return p.torque_NA.rms; }) + " N A. ";
    double deepest = 0;
    for (const BodyTradeOff& p : own) deepest = std::max(deepest, p.overlap_A.max);
    out += deepest > 0 ? "It overlaps the scene by up to " + readable(deepest) + " A.\n" : "It overlaps nothing.\n";
  }
  return out;
}

std::string bodyTradeOffChart(const std::vector<BodyTradeOff>& points) {
  std::vector<ChartPanel> panels{errorPanel(points, "Where the body is", "error of the position, rms (Å)",
                                            [](const BodyTradeOff& p) { return p.position_A.rms; }),
                                 errorPanel(points, "How it is turned", "error of the orientation, rms (rad)",
                                            [](const BodyTradeOff& p) { return p.turn_rad.rms; }),
                                 errorPanel(points, "What pushes", "error of the force, rms (N)",
                                            [](const BodyTradeOff& p) { return p.force_N.rms; }),
                                 errorPanel(points, "What turns", "error of the torque, rms (N Å)",
                                            [](const BodyTradeOff& p) { return p.torque_NA.rms; }),
                                 errorPanel(points, "How deep it lies in the scene", "overlap, rms (Å)",
                                            [](const BodyTradeOff& p) { return p.overlap_A.rms; })};
  ChartPanel size{"Time against size", "atoms of the body", "mean time of one tick, in loops", {}};
  for (const BodyMethod& m : bodyMethods()) {
    ChartSeries line{std::string(m.name), markOf(m), true, !m.reference, true, {}};
    for (const BodyTradeOff& p : points)
      if (p.method == &m) line.points.push_back({double(p.atoms), p.meanLoops(), ""});
    if (!line.points.empty()) size.series.push_back(std::move(line));
  }
  panels.push_back(std::move(size));
  return chartSvg(
      "Rigid bodies: speed against accuracy", panels,
      "Numbers beside the marks: atoms of the body. Left and down is better. Errors below 1e-13 have no mark. "
      "moltact bench bodies");
}

}  // namespace moltact::bench
