// Tick times of methods by the CPU's monotonic clock. Runs on the calling thread; allocates only between ticks. Units:
// nanosecond, second.
//
// The methods alternate stroke by stroke (A B A B …), so that changes of the machine's speed affect all equally. Even
// strokes are timed as a whole, for the mean. Odd strokes are timed tick by tick, for the percentiles; the clock's cost
// is subtracted, and their resolution is the clock's step (clock_step.h). A stroke during which the operating system
// preempted the thread is discarded.
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

/// The smallest time between two successive readings of the clock (unit: nanosecond).
double clockCost_ns();

struct TickTimes {
  const Method* method = nullptr;
  double mean_ns = 0;        ///< over whole strokes
  std::size_t dropped = 0;   ///< strokes discarded because of preemption
  Statistics single_ns;      ///< per tick; its mean includes the rest of the clock's cost
  double touching = 0;       ///< fraction of counted ticks in contact (0 to 1)
  double make_s = 0;         ///< from the prepared scene to the tracker's first tick, outside
  double first_touch_s = 0;  ///< duration of the tick of first contact; 0: none
  MemoryUsage memory_usage;  ///< at the end
};

/// Times the methods on the strokes. A method that has used `budget_s` of counted time is omitted from later rounds,
/// but not before two strokes.
std::vector<TickTimes> timeMethods(std::span<const Method* const> methods,
                                   const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                   const std::vector<Stroke>& strokes, double budget_s);

/// The time to prepare a scene from its spheres: the minimum of up to three runs (unit: second).
double scenePreparation_s(const std::vector<Sphere>& spheres);

}  // namespace moltact::bench
