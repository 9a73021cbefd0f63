// Speed against accuracy of methods for the energy of a held body with a scene: direct sums (PairSum, and in double
// precision) at several cut-offs, and grids (EnergyGrid). The right answer is the direct sum in double precision over all
// pairs, without a cut-off; a method's own error is that against the same sum with its cut-off. Units: angstrom, kcal/mol, microsecond, second, byte.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/energies/energy_task.h"
#include "engine/bench/report_table.h"
#include "engine/bench/statistics.h"
#include "engine/bench/timing.h"

namespace moltact::bench {

enum class EnergyKind : std::uint8_t { Double, Float, Trilinear, Tricubic, Nested };

struct EnergyMethod {
  EnergyKind kind = EnergyKind::Float;
  double size_A = 10.0;  ///< the cut-off of a direct sum, the spacing of a grid (of nested ones the fine one's)
  double cutoff_A() const;
  std::string name() const;
};

/// All methods of the chart.
std::vector<EnergyMethod> energyMethods();

/// A grid whose maps take more is not measured.
inline constexpr double kMaxMeasuredMaps_bytes = 300e6;

struct EnergyTradeOff {
  std::string body;
  std::size_t held = 0, scene = 0;
  EnergyMethod method;
  bool measured = false;  ///< false: the maps are too large
  double mean_us = 0, p999_us = 0;
  std::size_t judged = 0;
  Statistics energy, force, torque;          ///< amounts of the errors of the felt energy and its gradient
  Statistics own_force;                      ///< the same with the method's cut-off
  Statistics jump;                           ///< step of the force where an atom passes from one cell to the next
  double right_force = 0, right_torque = 0;  ///< rms
  std::size_t bytes = 0;
  double preparation_s = 0;
  double page_mean_us = 0, page_p999_us = 0;  ///< in a page (page_ticks.h); 0: not measured
};

struct EnergyTradeOffOptions {
  std::vector<std::string> bodies{kEnergyTasks.begin(), kEnergyTasks.end()};
  std::vector<EnergyMethod> methods = energyMethods();
  int ticks = 2000;
  int runs = 3;                ///< of the timing; each tick's time is the minimum
  double judged_pairs = 2e8;   ///< judges that many pairs, and from 20 to 400 ticks
  double min_spacing_A = 0.0;  ///< finer grids are left out
};

Expected<std::vector<EnergyTradeOff>> measureEnergies(const EnergyTradeOffOptions& options, const OpenMolecule& open,
                                                      const Progress& progress);

ReportTable energyTradeOffTable(const std::vector<EnergyTradeOff>& points, const EnergyTradeOffOptions& options);
std::string energyTradeOffSentences(const std::vector<EnergyTradeOff>& points);
std::string energyTradeOffChart(const std::vector<EnergyTradeOff>& points);

}  // namespace moltact::bench
