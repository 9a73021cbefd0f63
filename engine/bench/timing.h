// Tick times of methods by the CPU's monotonic clock. Runs on the calling thread; allocates only between
// ticks. Units: nanosecond, second.
//
// The methods take turns stroke by stroke (A B A B …), so that a change of the machine's speed meets all
// alike. Even strokes are timed whole, for the mean; odd ones tick by tick, for the percentiles, less the
// clock's own cost, and known no better than to the clock's step (clock_step.h). A stroke during which the operating
// system took the processor away says nothing of the method and is not counted.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/bench/statistics.h"
#include "engine/bench/strokes.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

/// Receives the progress of the work (0 to 1) and the name of its present part.
using Progress = std::function<void(double fraction, std::string_view what)>;

/// The least time between two successive readings of the clock (unit: nanosecond).
double clockCost_ns();

struct TickTimes {
  const Method* method = nullptr;
  double mean_ns = 0;        ///< over whole strokes
  std::size_t dropped = 0;   ///< strokes not counted because the processor was taken away
  Statistics single_ns;      ///< tick by tick; its mean includes what is left of the clock's cost
  double touching = 0;       ///< fraction of counted ticks in contact (0 to 1)
  double make_s = 0;         ///< from the scene to a tracker that has answered its first tick, outside
  double first_touch_s = 0;  ///< the tick that first met the surface; 0 when none did
  MemoryUsage memory_usage;  ///< at the end
};

/// Times the methods on the strokes. A method that has used `budget_s` of counted time drops out of later
/// rounds, but not before two strokes.
std::vector<TickTimes> timeMethods(std::span<const Method* const> methods,
                                   const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                   const std::vector<Stroke>& strokes, double budget_s);

/// The time to prepare a scene from its spheres, the least of up to three runs (unit: second).
double scenePreparation_s(const std::vector<Sphere>& spheres);

}  // namespace moltact::bench
