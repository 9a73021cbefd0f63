#include "engine/dynamics/simulation_slices.h"

#include <algorithm>
#include <chrono>

namespace moltact {

const SimulationFrame& SimulationSlices::advance(const SimulationCommand& wanted, double elapsed_s) {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  elapsed_s = std::clamp(elapsed_s, 0.0, kMaxElapsed_s);
  const int most = std::max(1, int(steps_per_s_ * std::max(kMaxStep_s, elapsed_s)));
  const SimulationFrame& frame = run_.advance(wanted, elapsed_s, most);
  if (run_.relaxing()) return frame;  // no steps were made
  const double took_s = std::chrono::duration<double>(Clock::now() - begun).count();
  const double steps = frame.ps_per_s * elapsed_s / run_.engine().step_ps();
  if (steps >= 5.0 && took_s > 1e-5) steps_per_s_ += 0.2 * (steps / took_s - steps_per_s_);
  return frame;
}

}  // namespace moltact
