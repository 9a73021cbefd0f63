// The changes that a fingertip would notice, the paper's Figure 1 in numbers: how much the force turns and changes from
// one tick to the next while the HIP slides over one sphere, along a crease and round a pit, 0.6 A deep, 0.02 A a tick.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/report_table.h"
#include "engine/bench/scenes.h"
#include "engine/bench/statistics.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

struct FeelPath {
  std::string name;
  scenes::Scene scene;
  scenes::Path approach;  ///< from outside to the first place, not counted
  scenes::Path counted;
};

/// "one sphere", "crease", "pit".
std::vector<FeelPath> feelPaths();

struct Feel {
  std::string path;
  const Method* method = nullptr;
  Statistics turn_deg;  ///< of the force's direction, a tick
  Statistics change_A;  ///< of SCP - HIP, a tick; times the stiffness it is the force's
  double lost = 0;      ///< fraction of ticks without contact
};

std::vector<Feel> measureFeel(const std::vector<const Method*>& methods);

ReportTable feelTable(const std::vector<Feel>& rows);

}  // namespace moltact::bench
