// The results of the last ticks for the plots, the status bar and the lesson: force over the last seconds, tick time
// and lateness of the loop. Window's thread. Units: newton, second, microsecond.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "app/ui/widgets/plot_buffer.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// The timing of the loop over the last half second.
struct LoopHealth {
  double rate_Hz = 0;      ///< number of ticks begun in the last second
  double late_p99_us = 0;  ///< 99th percentile of the time by which ticks began late
  double work_mean_us = 0, work_max_us = 0;
};

class TouchLog {
 public:
  static constexpr double kPlot_s = 5.0;           ///< time range of the plots
  static constexpr std::size_t kTicksAPoint = 10;  ///< a point of a plot is the maximum of this many ticks

  TouchLog();
  void add(const ServoSample& sample);
  /// Called once per frame after the samples: updates the displayed force. `now_s` is any steady clock.
  void figureForce(double now_s);
  /// Called once per frame: updates `health` twice a second.
  void measure(double now_s);

  const ServoSample& latest() const { return latest_; }
  const LoopHealth& health() const { return health_; }
  const PlotBuffer& force() const { return force_; }  ///< the maximum of every kTicksAPoint ticks (unit: newton)
  const PlotBuffer& work() const { return work_; }    ///< likewise (unit: microsecond)
  /// The parts of the molecular energy over the same time, in the order of EnergyPart, one value per point (unit:
  /// kcal/mol); empty where no forces between atoms act.
  std::span<const PlotBuffer> energies() const { return energies_; }
  /// The lowest sum of these parts in a tick since clear() or forgetLowest(), at most 0 (unit: kcal/mol). Ticks inside
  /// an atom do not count.
  double lowest_kcal_mol() const { return lowest_kcal_mol_; }
  /// For other forces.
  void forgetLowest() { lowest_kcal_mol_ = 0.0; }
  double force_N() const { return latest_force_N_; }
  /// The force that the whole window displays: rounded to tenths of a newton and changed at a readable pace.
  double shownForce_N() const { return shown_N_; }
  bool touching() const { return latest_.contact.touching(); }
  /// Whether a contact or a field exerts a force.
  bool felt() const { return latest_.felt(); }
  double greatest_N() const;  ///< the maximum in the plotted time

  /// Measures how long contact has lasted although the HIP is outside every sphere, as the caller determines
  /// (`hip_free`).
  void countLeftBehind(bool hip_free, double dt_s) {
    left_behind_s_ = touching() && hip_free ? left_behind_s_ + dt_s : 0.0;
  }
  double leftBehind_s() const { return left_behind_s_; }

  /// Clears everything for a new scene.
  void clear();

 private:
  ServoSample latest_;
  double latest_force_N_ = 0, left_behind_s_ = 0;
  double shown_N_ = 0, shown_since_s_ = 0;
  double lowest_kcal_mol_ = 0;
  PlotBuffer force_, work_;
  std::vector<PlotBuffer> energies_;
  float force_peak_ = 0, work_peak_ = 0;
  std::size_t in_point_ = 0;
  LoopHealth health_;
  std::vector<float> late_us_;  // since the last measurement
  double work_sum_us_ = 0, work_max_us_ = 0, measured_s_ = -1;
};

}  // namespace moltact
