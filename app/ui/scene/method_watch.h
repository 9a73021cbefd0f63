// Measures cost and accuracy of each method used on this molecule: tick times, and changes of the force's direction
// from tick to tick. Also the distance of its SCP from that of an exact tracker with the same hand path (referenceOf,
// engine/haptics/interactions.h). The exact tracker runs here, on the window's thread, over the ticks that the loop
// returns; while it is the method in use, its contacts are those of the ticks. Units: microsecond, angstrom, degree.
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

/// A histogram of the tick times of the last seconds of contact, by decades. Older ticks have less weight.
class TickHistogram {
 public:
  static constexpr double kMin_us = 0.05, kMax_us = 50.0;
  static constexpr int kBinsADecade = 16, kBins = 3 * kBinsADecade;

  void add(double time_us);  ///< Times beyond the ends count in the first or last bin; 0 (not timed) does not count.
  double share(int bin) const { return total_ > 0 ? counts_[std::size_t(bin)] / total_ : 0.0; }
  bool empty() const { return total_ <= 0; }
  /// The quantile of the tick times for this share, interpolated logarithmically within a bin; 0 if empty.
  double quantile_us(double share) const;

 private:
  std::array<double, kBins> counts_{};
  double total_ = 0;
};

struct MethodRecord {
  std::string method;
  TickHistogram times;    ///< of ticks in contact
  double error_A = 0;     ///< mean distance of the SCP from the exact one over the last kMemory_ticks in contact
  std::size_t ticks = 0;  ///< number in contact since the scene was opened
};

/// The distance of the tick's HIP from the nearest sphere inflated by the probe, with the spheres where they were in
/// that tick (like clearance() in engine/haptics/sweep.h; negative inside). `motion` is ServoLink::motionOf of the
/// tick.
double clearanceAt(const SphereGrid& resting, const ServoSample& sample, const SphereMotion* motion);

class MethodWatch {
 public:
  static constexpr std::size_t kMemory_ticks = 3000;
  static constexpr std::size_t kJudged_ticks = 100;  ///< a method with fewer ticks in contact is not charted

  MethodWatch();
  /// Begins a new scene without records.
  void begin(const TouchableModel& stage, const TouchSetup& felt);
  /// Continues the scene with other rendering parameters. After a change of method only, the exact tracker is kept. A
  /// change that affects every method's force needs a new one, which is led to the present contact.
  void feelWith(const TouchSetup& felt);
  /// Adds a tick of `method` during this motion of the spheres (null: at rest). Returns the exact tracker's contact for
  /// the same hand; a free contact before begin(). Ticks with a held body are not recorded.
  Contact add(const ServoSample& sample, const Method& method,
              const std::shared_ptr<const SphereMotion>& motion = nullptr);

  /// The exact tracker's contact in the last tick.
  const Contact& exact() const { return latest_exact_; }

  /// In the order of first use.
  const std::vector<MethodRecord>& tried() const { return tried_; }
  const MethodRecord* find(std::string_view method) const;
  /// The angle by which the force's direction changed in a tick, as the maximum of each TouchLog::kTicksAPoint ticks
  /// (unit: degree).
  const PlotBuffer& turns() const { return turns_; }
  /// The largest such angle in the plotted time.
  double greatestTurn_deg() const;

 private:
  std::unique_ptr<Interaction> makeReference(const TouchSetup& reference) const;
  Contact exactContact(const ServoSample& sample, const std::shared_ptr<const SphereMotion>& motion);
  MethodRecord& record(std::string_view method);
  void noteTurn(const ServoSample& sample);

  std::shared_ptr<const Molecule> molecule_;
  std::shared_ptr<const SphereGrid> spheres_;
  std::shared_ptr<const SphereMotion> motion_;  // outlives exact_, which reads it
  bool judges_ = false;
  std::unique_ptr<Interaction> exact_;  // null if what is felt is what it would give, or no method is judged
  TouchSetup reference_;                // with which exact_ was constructed, or would be
  ServoSample latest_;
  PoseA hand_{};           // in the last tick
  double fraction_ = 0.0;  // of motion_, in the last tick
  Contact latest_exact_;
  std::size_t left_behind_ticks_ = 0;
  std::vector<MethodRecord> tried_;
  PlotBuffer turns_;
  Vec3 displacement_before_{0.0};
  float turn_peak_deg_ = 0;
  std::size_t in_point_ = 0;
};

}  // namespace moltact
