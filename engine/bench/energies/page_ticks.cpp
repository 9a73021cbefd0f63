#include "engine/bench/energies/page_ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace moltact::bench {
namespace {

constexpr const char* kPageHeader = "body,method,mean_us,p999_us";

Problem pageLineProblem(int line, const std::string& what) {
  return {{},
          0,
          0,
          "line " + std::to_string(line) + " of the page's ticks: " + what,
          "use the lines that moltact_energy_ticks prints"};
}

std::optional<double> pageTime(const std::string& text) {
  std::istringstream in(text);
  double us = 0;
  if (!(in >> us) || !in.eof() || !std::isfinite(us) || us <= 0) return std::nullopt;
  return us;
}

bool isInChart(const std::string& body, const std::string& method) {
  const std::vector<EnergyMethod> methods = energyMethods();
  return std::find(kEnergyTasks.begin(), kEnergyTasks.end(), body) != kEnergyTasks.end() &&
         std::any_of(methods.begin(), methods.end(), [&](const EnergyMethod& m) { return m.name() == method; });
}

}  // namespace

std::vector<EnergyMethod> pageEnergyMethods() {
  return {{EnergyKind::Float, 10.0}, {EnergyKind::Trilinear, 0.375}, {EnergyKind::Tricubic, 0.375}};
}

std::string pageTickLines(const std::vector<EnergyTradeOff>& points) {
  std::string out = std::string(kPageHeader) + '\n';
  for (const EnergyTradeOff& p : points) {
    if (!p.measured) continue;
    char times[64];
    std::snprintf(times, sizeof times, ",%.4g,%.4g\n", p.mean_us, p.p999_us);
    out += p.body + ',' + p.method.name() + times;
  }
  return out;
}

std::optional<Problem> addPageTicks(const std::string& lines, std::vector<EnergyTradeOff>& points) {
  std::istringstream in(lines);
  std::string line;
  if (!std::getline(in, line) || line != kPageHeader)
    return pageLineProblem(1, "it is not '" + std::string(kPageHeader) + "'");
  for (int number = 2; std::getline(in, line); ++number) {
    std::vector<std::string> cells;
    std::istringstream cell_in(line);
    for (std::string cell; std::getline(cell_in, cell, ',');) cells.push_back(cell);
    if (cells.size() != 4) return pageLineProblem(number, "it has " + std::to_string(cells.size()) + " cells, not 4");
    const auto mean_us = pageTime(cells[2]), p999_us = pageTime(cells[3]);
    if (!mean_us || !p999_us) return pageLineProblem(number, "a time is not a positive number");
    const auto found = std::find_if(points.begin(), points.end(), [&](const EnergyTradeOff& p) {
      return p.body == cells[0] && p.method.name() == cells[1];
    });
    if (!isInChart(cells[0], cells[1]))
      return pageLineProblem(number, "'" + cells[1] + "' on '" + cells[0] + "' is not in the chart");
    if (found != points.end()) found->page_mean_us = *mean_us, found->page_p999_us = *p999_us;
  }
  return std::nullopt;
}

}  // namespace moltact::bench
