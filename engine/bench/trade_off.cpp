#include "engine/bench/trade_off.h"

#include <algorithm>

#include "engine/bench/hip_paths.h"
#include "engine/bench/methods/bench_methods.h"

namespace moltact::bench {

namespace {

// The strokes whose approach comes from within 60 degrees of +z; all, if there are none.
std::vector<Stroke> strokesFromAbove(std::vector<Stroke> strokes) {
  const auto from_above = [](const Stroke& s) {
    const Vec3 way = s.approach.front() - s.approach.back();
    return way.z >= 0.5 * glm::length(way);
  };
  if (std::none_of(strokes.begin(), strokes.end(), from_above)) return strokes;
  std::erase_if(strokes, [&](const Stroke& s) { return !from_above(s); });
  return strokes;
}

}  // namespace

std::vector<TradeOff> measureTradeOffs(const TradeOffOptions& options, const Progress& progress) {
  const auto at = [&](double fraction, std::string_view what) {
    if (progress) progress(fraction, what);
  };
  at(0, "preparing the strokes");
  const auto scene =
      std::make_shared<const SphereGrid>(proteinLike(options.spheres, static_cast<unsigned>(options.seed)));
  const auto strokes = contactStrokes(scene, options.probe_A, options.plan);
  at(0.1, "timing");
  std::vector<TradeOff> out;
  for (const TickTimes& t : timeMethods(options.methods, scene, options.probe_A, strokes, options.budget_s))
    out.push_back({t.method, t.mean_ns, {}, t.memory_usage, false, false});
  for (std::size_t k = 0; k < out.size(); ++k) {
    at(0.3 + 0.7 * double(k) / double(out.size()), out[k].method->name);
    const Method& method = *out[k].method;
    out[k].accuracy = isReference(method)
                          ? exactAgainstOracle(scene, options.probe_A, strokes, 250)
                          : accuracyOf(method, scene, options.probe_A,
                                       limitsOf(method).from_above ? strokesFromAbove(strokes) : strokes);
  }
  std::vector<double> cost, scp, direction;
  for (const TradeOff& one : out) {
    cost.push_back(one.tick_ns);
    scp.push_back(one.accuracy.scp_A.rms);
    direction.push_back(one.accuracy.direction_deg.rms);
  }
  for (const std::size_t k : paretoFront(cost, scp)) out[k].best_scp = true;
  for (const std::size_t k : paretoFront(cost, direction)) out[k].best_direction = true;
  at(1, "");
  return out;
}

ReportTable tradeOffTable(const std::vector<TradeOff>& points, const TradeOffOptions& options) {
  ReportTable t{"trade_off",
                "Speed against accuracy, sliding over " + readable(double(options.spheres)) + " spheres",
                {{"method", "method"},
                 {"tick_ns", "tick (ns)"},
                 {"scp_rms_A", "SCP error, rms (A)"},
                 {"scp_p50_A", "median (A)"},
                 {"scp_p99_A", "p99 (A)"},
                 {"scp_max_A", "max (A)"},
                 {"direction_rms_deg", "direction error, rms (deg)"},
                 {"direction_p50_deg", "median (deg)"},
                 {"direction_p99_deg", "p99 (deg)"},
                 {"lost_percent", "contact lost (%)"},
                 {"bytes", "memory (bytes)"},
                 {"best", "best trade-off in"}},
                {},
                readable(double(options.plan.strokes)) + " strokes of " + readable(double(options.plan.ticks)) +
                    " ticks over a protein-like cluster of " + readable(double(options.spheres)) +
                    " spheres, the HIP " + readable(options.plan.depth_A) + " A deep, " + readable(kStrokeStep_A) +
                    " A per tick, the probe " + readable(options.probe_A) +
                    " A. Errors are relative to exact; those of exact are relative to the brute-force oracle."};
  if (std::any_of(points.begin(), points.end(), [](const TradeOff& p) { return limitsOf(*p.method).from_above; }))
    t.note += " Those of a height field are over the strokes that come from within 60 degrees of its tip's direction.";
  for (const TradeOff& p : points) {
    const Accuracy& a = p.accuracy;
    const std::string best = p.best_scp && p.best_direction ? "place, direction"
                             : p.best_scp                   ? "place"
                             : p.best_direction             ? "direction"
                                                            : "";
    t.rows.push_back({std::string(p.method->name), p.tick_ns, a.scp_A.rms, a.scp_A.p50, a.scp_A.p99, a.scp_A.max,
                      a.direction_deg.rms, a.direction_deg.p50, a.direction_deg.p99, 100 * a.lost,
                      double(p.memory_usage.bytes), best});
  }
  return t;
}

}  // namespace moltact::bench
