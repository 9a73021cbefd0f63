// The perceptible errors of a method: its force compared with exact's in the same tick, relative to the thresholds of
// touch (touch_thresholds.h). Units: angstrom, newton, degree.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/bench/closed_loop.h"
#include "engine/bench/report_table.h"
#include "engine/bench/statistics.h"
#include "engine/bench/strokes.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

/// Relative errors refer to a force of at least this size, because smaller forces have larger thresholds.
inline constexpr double kMinForce_N = 0.3;

/// Errors over the ticks in which exact touches. Fractions are 0 to 1.
struct FeltErrors {
  std::string where;
  const Method* method = nullptr;
  std::size_t ticks = 0;           ///< in contact
  Statistics direction_deg;        ///< angle to exact's force, where both push
  double direction_seen = 0;       ///< fraction above kDirectionSeen_deg
  double direction_blind = 0;      ///< fraction above kDirectionBlind_deg
  double size = 0, size_wide = 0;  ///< fraction whose size of force differs by more than kForceWeber, kForceWeberWide
  /// Events per second: the force steps by these fractions more than exact's does within two ticks.
  double steps = 0, steps_wide = 0;
  double off = 0;   ///< fraction with the SCP farther than kPlaceFelt_A from exact's
  double lost = 0;  ///< fraction without contact
};

/// Measures one method along strokes; both trackers are reset at each stroke.
FeltErrors feltOn(const std::string& where, const Method& method, const std::shared_ptr<const SphereGrid>& scene,
                  double probe_A, const std::vector<Stroke>& strokes, const LoopSettings& loop = {});

/// Combines the errors of several scenes, weighted by their ticks.
FeltErrors together(const std::string& where, const std::vector<FeltErrors>& parts);

/// One row per method; `ns`, the mean time of a tick for each row, may be empty.
ReportTable feltTable(std::string name, std::string title, const std::vector<FeltErrors>& rows,
                      const std::vector<double>& ns = {});

/// Sentences that state which errors of the methods in the rows a hand can notice.
std::string feltSentences(const std::vector<FeltErrors>& rows);

}  // namespace moltact::bench
