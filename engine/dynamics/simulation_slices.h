// A simulation in slices that take a bounded time, by the speed that its engine has shown: for a thread or a worker that
// must answer soon. One thread at a time.
#pragma once

#include <memory>

#include "engine/dynamics/live_simulation.h"

namespace moltact {

class SimulationSlices {
 public:
  explicit SimulationSlices(std::unique_ptr<MdEngine> engine) : run_(std::move(engine)) {}

  const MdEngine& engine() const { return run_.engine(); }
  /// Carries out the command for `elapsed_s` of the window's time, at most kMaxElapsed_s of it. The computation takes about
  /// kMaxStep_s at most, or `elapsed_s` if that is longer. The reference is valid until the next call.
  const SimulationFrame& advance(const SimulationCommand& wanted, double elapsed_s);
  /// Whether a relaxation goes on in the next call; then no pause between the calls is of use.
  bool relaxing() const { return run_.relaxing(); }

  static constexpr double kMaxStep_s = 0.02, kMaxElapsed_s = 0.1;

 private:
  SimulationRun run_;
  double steps_per_s_ = 1000.0;  // until it is measured
};

}  // namespace moltact
