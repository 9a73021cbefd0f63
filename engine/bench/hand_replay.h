// Recorded hands, led through every method. The way is fixed: a hand that felt another method would have gone
// another way. Units: second, nanosecond.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/felt.h"
#include "engine/bench/hand_path.h"
#include "engine/bench/timing.h"

namespace moltact::bench {

/// A hand's way laid on its molecule.
struct HandOnMolecule {
  HandPath path;
  std::string molecule;
  std::shared_ptr<const SphereGrid> scene;
};

struct HandReplay {
  std::string name, device, hand, stroke, molecule;
  double seconds = 0, touching = 0;  ///< fraction of ticks in which exact touches (0 to 1)
  std::vector<FeltErrors> felt;      ///< a method each
  std::vector<double> tick_ns;       ///< mean of each; 0: not timed
};

/// Every hand through every method; `timed` methods are also timed, for `budget_s` each.
std::vector<HandReplay> replayHands(const std::vector<HandOnMolecule>& hands, const std::vector<const Method*>& methods,
                                    const std::vector<const Method*>& timed, double budget_s, const Progress& progress);

/// A row a hand: what it is.
ReportTable handsTable(const std::vector<HandReplay>& hands);
/// A row a method, over all hands.
ReportTable handsFeltTable(const std::vector<HandReplay>& hands);
/// A row a hand and method.
ReportTable handsFigures(const std::vector<HandReplay>& hands);
/// All hands together, a method each.
std::vector<FeltErrors> feltOverAll(const std::vector<HandReplay>& hands);

}  // namespace moltact::bench
