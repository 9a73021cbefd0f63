// Table, sentences and chart of energy_trade_off.h.
#include <algorithm>

#include "engine/bench/chart_svg.h"
#include "engine/bench/energies/energy_trade_off.h"

namespace moltact::bench {
namespace {

constexpr const char* kEnergyKindTitles[] = {"direct sum, double", "direct sum, float", "grid, trilinear",
                                             "grid, tricubic", "nested grids"};

std::string energyBodyTitle(const std::string& body) {
  if (body == "ligand") return "Force on a ligand";
  return body == "200" ? "Force on 200 atoms" : "Force on a chain";
}

template <class Error>
ChartPanel energyPanel(const std::vector<EnergyTradeOff>& points, const std::string& body, std::string title,
                       std::string y_axis, Error error) {
  ChartPanel panel{std::move(title), "mean time of one tick (µs)", std::move(y_axis), {}};
  for (std::size_t kind = 0; kind < std::size(kEnergyKindTitles); ++kind) {
    ChartSeries series{kEnergyKindTitles[kind], markAt(kind), true, false, true, {}};
    for (const EnergyTradeOff& p : points)
      if (p.measured && p.body == body && std::size_t(p.method.kind) == kind)
        series.points.push_back({p.mean_us, error(p), constant(p.method.size_A)});
    if (!series.points.empty()) panel.series.push_back(std::move(series));
  }
  ChartSeries page{"direct sum, float, in a page", Mark::Circle, false, false, true, {}};
  for (const EnergyTradeOff& p : points)
    if (p.page_mean_us > 0 && p.body == body && p.method.kind == EnergyKind::Float)
      page.points.push_back({p.page_mean_us, error(p), constant(p.method.size_A)});
  if (!page.points.empty()) panel.series.push_back(std::move(page));
  return panel;
}

const EnergyTradeOff* energyPoint(const std::vector<EnergyTradeOff>& points, const std::string& body, EnergyKind kind,
                                  double size_A) {
  for (const EnergyTradeOff& p : points)
    if (p.measured && p.body == body && p.method.kind == kind && p.method.size_A == size_A) return &p;
  return nullptr;
}

}  // namespace

ReportTable energyTradeOffTable(const std::vector<EnergyTradeOff>& points, const EnergyTradeOffOptions& options) {
  ReportTable t{"energy_trade_off",
                "Energies between atoms: speed against accuracy",
                {{"body", "body"},
                 {"method", "method"},
                 {"mean_us", "tick, mean (us)"},
                 {"p999_us", "p99.9 (us)"},
                 {"page_mean_us", "in a page, mean (us)"},
                 {"page_p999_us", "in a page, p99.9 (us)"},
                 {"force_rms", "force error, rms (kcal/mol/A)"},
                 {"force_p99", "p99"},
                 {"right_force", "force, rms (reference)"},
                 {"own_force_rms", "force error against a sum with the same cut-off, rms"},
                 {"torque_rms", "torque error, rms (kcal/mol)"},
                 {"torque_p99", "p99"},
                 {"right_torque", "torque, rms (reference)"},
                 {"energy_rms", "energy error, rms (kcal/mol)"},
                 {"energy_p99", "p99"},
                 {"jump_rms", "step of the force between cells, rms (kcal/mol/A)"},
                 {"jump_max", "max"},
                 {"memory_MB", "memory (MB)"},
                 {"preparation_s", "preparation (s)"}},
                {},
                ""};
  const auto atoms = [&](const std::string& body) -> std::string {
    for (const EnergyTradeOff& p : points)
      if (p.body == body) return std::to_string(p.held) + " against " + std::to_string(p.scene);
    return "not measured";
  };
  t.note =
      "Atoms with polar hydrogens: ligand (amprenavir in 1HPV) " + atoms("ligand") +
      "; 200 of 2HHB's chain A nearest to B " + atoms("200") + "; chain A against B " + atoms("chain") +
      ". The path has " + readable(double(options.ticks)) +
      " ticks. From the crystal pose the body moves by up to 0.5 A to either side along each axis. It also turns "
      "about each axis by up to 0.5 A at its radius of gyration. A tick's time is the minimum of " +
      std::to_string(options.runs) +
      " runs. Errors are of the felt energy (walls bounded by asinh above 1 kcal/mol per atom). The reference is the "
      "sum "
      "over all pairs in double precision without a cut-off, at up to 400 ticks. The number of a direct sum is its "
      "cut-off, of a grid its spacing; grids have a cut-off of 10 A and walls folded at 4 kcal/mol; `nested` is "
      "tricubic, 0.2 A within 0.75 A. Maps of more than " +
      readable(kMaxMeasuredMaps_bytes / 1e6) +
      " MB are not measured (empty cells). Of the methods in a page three are measured: the same code as WebAssembly "
      "under "
      "Node.js.";
  for (const EnergyTradeOff& p : points) {
    std::vector<Cell> row(t.columns.size());
    row[0] = p.body;
    row[1] = p.method.name();
    if (p.measured) {
      row[2] = p.mean_us, row[3] = p.p999_us;
      if (p.page_mean_us > 0) row[4] = p.page_mean_us, row[5] = p.page_p999_us;
      const double values[] = {p.force.rms,  p.force.p99,           p.right_force,  p.own_force.rms, p.torque.rms,
                               p.torque.p99, p.right_torque,        p.energy.rms,   p.energy.p99,    p.jump.rms,
                               p.jump.max,   double(p.bytes) / 1e6, p.preparation_s};
      for (std::size_t k = 0; k < std::size(values); ++k) row[k + 6] = values[k];
    }
    t.rows.push_back(std::move(row));
  }
  return t;
}

std::string energyTradeOffSentences(const std::vector<EnergyTradeOff>& points) {
  std::string out;
  for (const std::string body : {"ligand", "200", "chain"}) {
    const EnergyTradeOff* direct = energyPoint(points, body, EnergyKind::Float, 10.0);
    if (!direct) continue;
    const auto share = [](const EnergyTradeOff& p) { return readable(100 * p.force.rms / p.right_force) + " %"; };
    out += "* " +
           std::string(body == "ligand" ? "Ligand"
                       : body == "200"  ? "200 atoms"
                                        : "Chain") +
           ": `" + direct->method.name() + "` takes " + readable(direct->mean_us) +
           " us a tick and has an error of the force of " + share(*direct) + " (rms) from its cut-off and of " +
           readable(direct->own_force.rms) + " kcal/mol/A from rounding";
    if (direct->page_mean_us > 0) out += " (in a page " + readable(direct->page_mean_us) + " us)";
    for (const EnergyKind kind : {EnergyKind::Trilinear, EnergyKind::Tricubic})
      if (const EnergyTradeOff* grid = energyPoint(points, body, kind, 0.375))
        out += "; `" + grid->method.name() + "` " + readable(grid->mean_us) + " us and " + share(*grid) +
               ", with steps of up to " + readable(grid->jump.max) + " kcal/mol/A between cells";
    if (const EnergyTradeOff* grid = energyPoint(points, body, EnergyKind::Nested, 0.2))
      out += "; `" + grid->method.name() + "` " + readable(grid->mean_us) + " us and " + share(*grid);
    out += ".\n";
  }
  return out;
}

std::string energyTradeOffChart(const std::vector<EnergyTradeOff>& points) {
  std::vector<ChartPanel> panels;
  for (const std::string body : {"ligand", "200", "chain"})
    panels.push_back(energyPanel(points, body, energyBodyTitle(body), "error of the force, rms (kcal/mol/Å)",
                                 [](const EnergyTradeOff& p) { return p.force.rms; }));
  panels.push_back(energyPanel(points, "ligand", "Against a sum with the same cut-off",
                               "error of a ligand's force, rms (kcal/mol/Å)",
                               [](const EnergyTradeOff& p) { return p.own_force.rms; }));
  panels.push_back(energyPanel(points, "ligand", "Torque on a ligand", "error of the torque, rms (kcal/mol)",
                               [](const EnergyTradeOff& p) { return p.torque.rms; }));
  panels.push_back(energyPanel(points, "ligand", "Energy of a ligand", "error of the energy, rms (kcal/mol)",
                               [](const EnergyTradeOff& p) { return p.energy.rms; }));
  panels.push_back(energyPanel(points, "ligand", "Steps on a ligand",
                               "step of the force between cells, rms (kcal/mol/Å)",
                               [](const EnergyTradeOff& p) { return p.jump.rms; }));
  std::erase_if(panels, [](const ChartPanel& p) { return p.series.empty(); });
  return chartSvg(
      "Energies between atoms: speed against accuracy", panels,
      "Numbers beside the marks: cut-off of a direct sum, spacing of a grid, in Å. Left and down is better. "
      "moltact bench energies");
}

}  // namespace moltact::bench
