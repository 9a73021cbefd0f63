// Turns servo samples into touches (what was held, how hard, how far) and the HIP samples of an attempt. Window's
// thread.
// Units: second of use, angstrom, newton.
#pragma once

#include <vector>

#include "engine/lesson/touch_sample.h"
#include "engine/results/attempt.h"

namespace moltact {

class TouchWatch {
 public:
  /// One tick; `t_s` is its time of use. Ticks whose numbers are not finite are passed over.
  void add(const TouchSample& sample, double t_s, InputWay by);
  /// The stage or the attempt changes: a touch under way ends here.
  void breakOff();

  /// The events that are complete since the last call: touches at once, HIP samples at least every kHipChunk_s; and for
  /// a touch that goes on, every kHeartbeat_s, its figures so far.
  std::vector<AttemptEvent> take(double t_s);

  static constexpr double kSample_s = 1.0 / 60.0;   ///< samples are kept at most so often
  static constexpr double kChange_s = 1.0 / 250.0;  ///< but so often where the feature or the atoms change
  static constexpr double kStill_A = 0.002;         ///< a hand that has moved less gives none
  static constexpr double kUnturned = 0.002;        ///< nor one that has turned a body by less (unit: radian)
  static constexpr double kHipChunk_s = 0.5;        ///< what a HipChunk holds at most

 private:
  struct Touch {
    TouchEnded told;
    std::array<std::int32_t, 3> atoms{-1, -1, -1};
    Vec3 scp_A{0.0};
    double last_s = 0.0, told_s = 0.0, force_sum_N = 0.0;
    std::size_t ticks = 0;
  };
  void follow(const TouchSample& sample, double t_s, InputWay by);
  void keepHip(const TouchSample& sample, double t_s);
  void end();
  void endPath();
  double mean_N() const;

  bool touching_ = false;
  Touch touch_;
  std::vector<HipSample> hips_;
  HipSample before_;  // the last that was kept
  bool has_before_ = false, rested_ = false;
  HipSample resting_;  // of a hand at rest, written when it moves again
  std::vector<AttemptEvent> ready_;
};

}  // namespace moltact
