#include "engine/bench/charts.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/bench/chart_svg.h"
#include "engine/bench/methods/bench_methods.h"
#include "engine/core/text.h"

namespace moltact::bench {
namespace {

// One mark per family, in the order of benchMethods().
Mark markOf(const MethodFamily& family) {
  std::vector<std::string_view> before;
  for (const Method& m : benchMethods()) {
    if (m.family.name == family.name) break;
    if (std::find(before.begin(), before.end(), m.family.name) == before.end()) before.push_back(m.family.name);
  }
  return markAt(before.size());
}

template <class Error, class Best>
ChartPanel tradeOffPanel(const std::vector<TradeOff>& points, std::string title, std::string y_axis, Error error,
                         Best best) {
  ChartPanel panel{std::move(title), "mean time of one tick in contact (ns)", std::move(y_axis), {}};
  ChartSeries front{"best trade-offs", Mark::Disc, true, true, false, {}};
  for (const TradeOff& p : points) {
    const MethodFamily& family = p.method->family;
    const std::string name = lower(std::string(family.name));
    auto series =
        std::find_if(panel.series.begin(), panel.series.end(), [&](const ChartSeries& s) { return s.name == name; });
    if (series == panel.series.end())
      series = panel.series.insert(series, ChartSeries{name, markOf(family), false, false, true, {}});
    series->points.push_back({p.tick_ns, error(p), std::string(p.method->name)});
    if (best(p)) front.points.push_back({p.tick_ns, error(p), ""});
  }
  std::sort(front.points.begin(), front.points.end(),
            [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; });
  panel.series.insert(panel.series.begin(), std::move(front));
  return panel;
}

}  // namespace

std::string tradeOffChart(const std::vector<TradeOff>& points, std::size_t spheres) {
  return chartSvg(
      "Speed against accuracy, sliding over " + readable(double(spheres)) + " spheres",
      {tradeOffPanel(
           points, "Where the surface is", "error of the SCP, rms (Å)",
           [](const TradeOff& p) { return p.accuracy.scp_A.rms; }, [](const TradeOff& p) { return p.best_scp; }),
       tradeOffPanel(
           points, "Which way it pushes", "error of the force's direction, rms (degrees)",
           [](const TradeOff& p) { return p.accuracy.direction_deg.rms; },
           [](const TradeOff& p) { return p.best_direction; })},
      "Left and down is better. Errors against exact; those of exact against the brute-force "
      "oracle. moltact bench chart");
}

std::string sizeChart(const std::vector<SceneTimes>& times) {
  // Too many lines would be unreadable; these methods represent their kinds.
  const std::string_view reference = referenceMethod().name;
  const std::array<std::string_view, 6> shown{reference, "paper", "mesh960", "sasmesh05", "grid04", "penalty"};
  ChartPanel memory{"Memory of the method after sliding", "atoms loaded", "bytes", {}},
      ready{"Until the scene can be touched", "atoms loaded", "milliseconds", {}};
  for (const std::string_view name : shown) {
    ChartSeries bytes{std::string(name), markOf(findBenchMethod(name)->family), true, name != reference, true, {}},
        ms = bytes;
    for (const SceneTimes& scene : times)
      for (const TickTimes& row : scene.contact) {
        if (row.method->name != name) continue;
        bytes.points.push_back({double(scene.spheres), double(row.memory_usage.bytes),
                                readable(double(row.memory_usage.atoms_modelled)) + " modelled"});
        ms.points.push_back({double(scene.spheres), 1e3 * (scene.scene_s + row.make_s + row.first_touch_s), ""});
      }
    const auto by_size = [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; };
    std::sort(bytes.points.begin(), bytes.points.end(), by_size);
    std::sort(ms.points.begin(), ms.points.end(), by_size);
    // Where points are crowded, only the first of them is labelled.
    double labelled = 0;
    for (ChartPoint& p : bytes.points) {
      if (name != reference || p.x < 8 * labelled)
        p.label.clear();
      else
        labelled = p.x;
    }
    if (bytes.points.empty()) continue;
    memory.series.push_back(std::move(bytes));
    ready.series.push_back(std::move(ms));
  }
  return chartSvg("Memory and ready time against the size of the scene", {memory, ready},
                  "\"modelled\": atoms for which exact holds more than centre and radius, of those loaded. "
                  "moltact bench tables");
}

}  // namespace moltact::bench
