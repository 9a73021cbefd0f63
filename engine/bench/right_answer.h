// The reference SCP of each tick, by which a method is judged. The reference is the method `exact`; where `exact`
// itself is judged, it is the brute-force oracle.
// Units: angstrom.
#pragma once

#include <memory>
#include <optional>

#include "engine/bench/oracle.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/exact/exact_tracker.h"

namespace moltact::bench {

class RightAnswer {
 public:
  /// `by_oracle`: use the oracle as reference, else exact.
  RightAnswer(const scenes::Scene& scene, bool by_oracle);

  struct Answer {
    bool touching = false;
    Vec3 scp_A{0.0};    ///< the HIP if there is no contact
    bool known = true;  ///< oracle only: false if two results are correct, or the probe has just changed
  };

  /// Performs one tick. `given` is the judged method's answer, from which the oracle continues if its own is undecided.
  Answer step(const Vec3& hip, const Contact& given);
  void setProbe(double probe_A);
  void swap(const scenes::Scene& scene);
  void reset();

 private:
  scenes::Scene scene_;
  std::optional<ExactTracker> exact_;
  std::optional<oracle::Oracle> oracle_;
  bool moved_ = false;  // oracle only: the probe has changed since the last tick
};

}  // namespace moltact::bench
