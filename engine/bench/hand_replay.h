// Replays recorded hands through every method. The path is fixed, although a hand that had felt another method would
// have moved differently. Units: second, nanosecond.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/felt.h"
#include "engine/bench/timing.h"
#include "engine/servo/hand_path.h"

namespace moltact::bench {

/// A hand's path mapped to its molecule.
struct HandOnMolecule {
  HandPath path;
  std::string molecule;
  std::shared_ptr<const SphereGrid> scene;
};

struct HandReplay {
  std::string name, device, hand, stroke, molecule;
  double seconds = 0, touching = 0;  ///< fraction of ticks in which exact touches (0 to 1)
  std::vector<FeltErrors> felt;      ///< one per method
  std::vector<double> tick_ns;       ///< mean of each method; 0: not timed
};

/// Replays every hand through every method; `timed` methods are also timed, for `budget_s` each.
std::vector<HandReplay> replayHands(const std::vector<HandOnMolecule>& hands, const std::vector<const Method*>& methods,
                                    const std::vector<const Method*>& timed, double budget_s, const Progress& progress);

/// One row per hand: its description.
ReportTable handsTable(const std::vector<HandReplay>& hands);
/// One row per method, over all hands.
ReportTable handsFeltTable(const std::vector<HandReplay>& hands);
/// One row per hand and method.
ReportTable handsFigures(const std::vector<HandReplay>& hands);
/// The errors over all hands together, one element per method.
std::vector<FeltErrors> feltOverAll(const std::vector<HandReplay>& hands);

}  // namespace moltact::bench
