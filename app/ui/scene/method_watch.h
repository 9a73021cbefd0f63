// The cost and the accuracy of each method tried on this molecule: tick times, the turn of the force from tick to tick,
// and the distance of its SCP from that of an exact tracker that is led by the same hand, made as what is felt is made
// (referenceOf, engine/haptics/interactions.h). The exact tracker runs here, on the window's thread, over the ticks that the loop hands back. Units: microsecond, angstrom, degree.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/ui/scene/touch_log.h"
#include "app/ui/scene/touchable_model.h"
#include "engine/haptics/methods.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// Tick times of the last few seconds of contact, by decades. Older ones fade.
class TickHistogram {
 public:
  static constexpr double kMin_us = 0.05, kMax_us = 50.0;
  static constexpr int kBinsADecade = 16, kBins = 3 * kBinsADecade;

  void add(double time_us);  ///< times beyond the ends count in the last bin; 0 (not timed) does not count
  double share(int bin) const { return total_ > 0 ? counts_[std::size_t(bin)] / total_ : 0.0; }
  bool empty() const { return total_ <= 0; }
  /// The time that this share of the ticks stays within, between bins by their logarithms; 0 when empty.
  double quantile_us(double share) const;

 private:
  std::array<double, kBins> counts_{};
  double total_ = 0;
};

struct MethodRecord {
  std::string method;
  TickHistogram times;    ///< of ticks in contact
  double error_A = 0;     ///< mean distance of the SCP from the exact one, of the last kMemory_ticks in contact
  std::size_t ticks = 0;  ///< in contact, since the scene was opened
};

/// How far the tick's HIP is from the nearest sphere that its probe inflates, where the spheres were in that tick (as
/// clearance() in engine/haptics/sweep.h; negative inside); the motion is ServoLink::motionOf of the tick.
double clearanceAt(const SphereGrid& resting, const ServoSample& sample, const SphereMotion* motion);

class MethodWatch {
 public:
  static constexpr std::size_t kMemory_ticks = 3000;
  static constexpr std::size_t kJudged_ticks = 100;  ///< a method touched with for less has no place in a chart

  MethodWatch();
  /// A new scene: nothing has been tried.
  void begin(const TouchableModel& stage, const TouchSetup& felt);
  /// The same scene is felt otherwise from here on. Another method goes on beside the same exact tracker; what changes
  /// the force of every method needs another, which is led to the contact there is.
  void feelWith(const TouchSetup& felt);
  /// One tick that `method` made, in that motion of the spheres (null: they are at rest). Gives the exact tracker's
  /// contact for the same hand; free before begin(). What is felt as a body, and not as a point, is none of its ticks.
  Contact add(const ServoSample& sample, const Method& method,
              const std::shared_ptr<const SphereMotion>& motion = nullptr);

  /// The exact tracker's contact at the last tick.
  const Contact& exact() const { return latest_exact_; }

  /// In the order in which they were first touched with.
  const std::vector<MethodRecord>& tried() const { return tried_; }
  const MethodRecord* find(std::string_view method) const;
  /// Degrees by which the force's direction turned in a tick, the largest of every TouchLog::kTicksAPoint.
  const PlotBuffer& turns() const { return turns_; }
  /// The largest turn in the plotted time.
  double greatestTurn_deg() const;

 private:
  MethodRecord& record(std::string_view method);
  void noteTurn(const ServoSample& sample);

  std::shared_ptr<const SphereGrid> spheres_;
  std::shared_ptr<const SphereMotion> motion_;  // outlives exact_, which reads it
  std::unique_ptr<Interaction> exact_;
  TouchSetup reference_;   // what exact_ was made with
  PoseA hand_{};           // at the last tick
  double fraction_ = 0.0;  // of motion_, at the last tick
  Contact latest_exact_;
  std::size_t left_behind_ticks_ = 0;
  std::vector<MethodRecord> tried_;
  PlotBuffer turns_;
  Vec3 displacement_before_{0.0};
  float turn_peak_deg_ = 0;
  std::size_t in_point_ = 0;
};

}  // namespace moltact
