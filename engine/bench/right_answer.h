// The reference SCP of each tick, by which a method is judged. The reference is the method `exact`; where `exact`
// itself is judged, it is the brute-force oracle. Friction acts on the reference as on the method.
// Units: angstrom.
#pragma once

#include <memory>
#include <optional>

#include "engine/bench/oracle_tracker.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/servo/servo_step.h"

namespace moltact::bench {

class RightAnswer {
 public:
  /// `by_oracle`: use the oracle as reference, else exact. `friction`: of a layer on it; empty: none.
  RightAnswer(const scenes::Scene& scene, bool by_oracle, const std::optional<Friction>& friction = std::nullopt);

  struct Answer {
    bool touching = false;
    Vec3 scp_A{0.0};           ///< the HIP if there is no contact
    Vec3 displacement_A{0.0};  ///< of the spring, as Contact::displacement_A
    bool known = true;         ///< oracle only: false if two results are correct, or the probe has just changed
  };

  /// Performs one tick. `given` is the judged method's answer, from which the oracle continues if its own is undecided.
  Answer step(const Vec3& hip, const Contact& given);
  void setProbe(double probe_A);
  void setSurface(const SurfaceProperties& surface) { felt_->setSurface(surface); }
  /// The spheres move to this phase before the next step.
  void setMotion(const MotionPhase& phase);
  void swap(const scenes::Scene& scene);
  void reset();

 private:
  void make();

  scenes::Scene scene_;
  bool by_oracle_;
  std::optional<Friction> friction_;
  std::unique_ptr<Interaction> felt_;
  OracleTracker* oracle_ = nullptr;  // inside felt_; null: exact
  std::optional<Vec3> last_hip_;
  bool probe_changed_ = false, moved_ = false;
};

}  // namespace moltact::bench
