// The results of the last ticks, for the plots, the status bar and the lesson: force over the last seconds, the loop's
// tick time and lateness. Window's thread. Units: newton, second, microsecond.
#pragma once

#include <cstddef>
#include <vector>

#include "app/ui/widgets/plot_buffer.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// How well the loop kept its time over the last half second.
struct LoopHealth {
  double rate_Hz = 0;      ///< ticks begun in the last second
  double late_p99_us = 0;  ///< 99 of 100 ticks began no later than this after their time
  double work_mean_us = 0, work_max_us = 0;
};

class TouchLog {
 public:
  static constexpr double kPlot_s = 5.0;           ///< how far back the plots go
  static constexpr std::size_t kTicksAPoint = 10;  ///< a point of a plot is the largest of so many ticks

  TouchLog();
  void add(const ServoSample& sample);
  /// Once a frame, after the samples: renews the figure of the force. `now_s` is any steady clock.
  void figureForce(double now_s);
  /// The same, renews `health` twice a second.
  void measure(double now_s);

  const ServoSample& latest() const { return latest_; }
  const LoopHealth& health() const { return health_; }
  const PlotBuffer& force() const { return force_; }  ///< N, the largest of every kTicksAPoint ticks
  const PlotBuffer& work() const { return work_; }    ///< us, likewise
  double force_N() const { return latest_force_N_; }
  /// The force as every figure of the window says it at once: in tenths of a newton, changed at a pace that can be read.
  double shownForce_N() const { return shown_N_; }
  bool touching() const { return latest_.contact.touching(); }
  /// A force is felt, of a contact or of a field.
  bool felt() const { return latest_.felt(); }
  double greatest_N() const;  ///< over the plotted time

  /// For how long there has been contact although the HIP has been outside every sphere; the caller says whether it is.
  void countLeftBehind(bool hip_free, double dt_s) {
    left_behind_s_ = touching() && hip_free ? left_behind_s_ + dt_s : 0.0;
  }
  double leftBehind_s() const { return left_behind_s_; }

  /// Nothing has been felt yet: at a new scene.
  void clear();

 private:
  ServoSample latest_;
  double latest_force_N_ = 0, left_behind_s_ = 0;
  double shown_N_ = 0, shown_since_s_ = 0;
  PlotBuffer force_, work_;
  float force_peak_ = 0, work_peak_ = 0;
  std::size_t in_point_ = 0;
  LoopHealth health_;
  std::vector<float> late_us_;  // since the last measurement
  double work_sum_us_ = 0, work_max_us_ = 0, measured_s_ = -1;
};

}  // namespace moltact
