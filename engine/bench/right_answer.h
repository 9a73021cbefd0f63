// The reference SCP, tick by tick, for judging a method: exact's answer, and for exact itself the brute-force oracle's.
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
  /// `by_oracle`: judge by the oracle, else by exact.
  RightAnswer(const scenes::Scene& scene, bool by_oracle);

  struct Answer {
    bool touching = false;
    Vec3 scp_A{0.0};    ///< the HIP when not touching
    bool known = true;  ///< false where two outcomes are right, or where the surface itself has just moved
  };

  /// One tick; `given` is the judged method's answer, from which the oracle goes on where it cannot know.
  Answer step(const Vec3& hip, const Contact& given);
  void setProbe(double probe_A);
  void swap(const scenes::Scene& scene);
  void reset();

 private:
  scenes::Scene scene_;
  std::optional<ExactTracker> exact_;
  std::optional<oracle::Oracle> oracle_;
  bool moved_ = false;  // the probe has changed since the last tick
};

}  // namespace moltact::bench
