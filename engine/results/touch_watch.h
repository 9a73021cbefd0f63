// Converts servo samples to touches (atoms, forces, path length) and to the HIP samples of an attempt. A touch is a
// contact: a field acts on all atoms at once and is kept as the force of the HIP samples. Window's thread.
// Units: second of use, angstrom, newton.
#pragma once

#include <vector>

#include "engine/lesson/touch_sample.h"
#include "engine/results/attempt.h"

namespace moltact {

class TouchWatch {
 public:
  /// Adds one tick at the time of use `t_s`. Ticks with numbers that are not finite are ignored.
  void add(const TouchSample& sample, double t_s, InputKind by);
  /// Ends a touch in progress, because the scene or the attempt changes.
  void breakOff();

  /// Returns the events completed since the last call. Touches are returned at once, HIP samples at least every
  /// kHipChunk_s, and figures of a touch in progress every kHeartbeat_s.
  std::vector<AttemptEvent> take(double t_s);

  static constexpr double kSample_s = 1.0 / 60.0;   ///< minimum interval between samples
  static constexpr double kChange_s = 1.0 / 250.0;  ///< minimum interval if the feature or the atoms change
  static constexpr double kStill_A = 0.002;         ///< a smaller motion counts as rest and gives no sample
  static constexpr double kUnturned = 0.002;        ///< a smaller rotation of a body counts as rest (unit: radian)
  static constexpr double kHipChunk_s = 0.5;        ///< maximum duration of a HipChunk

 private:
  struct Touch {
    TouchEnded event;
    std::array<std::int32_t, 3> atoms{-1, -1, -1};
    Vec3 scp_A{0.0};
    double last_s = 0.0, written_s = 0.0, force_sum_N = 0.0;
    std::size_t ticks = 0;
  };
  void follow(const TouchSample& sample, double t_s, InputKind by);
  void keepHip(const TouchSample& sample, double t_s);
  void end();
  void endPath();
  double mean_N() const;

  bool touching_ = false;
  Touch touch_;
  std::vector<HipSample> hips_;
  HipSample before_;  // the last sample kept
  bool has_before_ = false, rested_ = false;
  HipSample resting_;  // the last sample of a rest, written when the hand moves again
  std::vector<AttemptEvent> ready_;
};

}  // namespace moltact
