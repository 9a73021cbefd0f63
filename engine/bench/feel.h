// Changes that a fingertip can notice, corresponding to the paper's Figure 1. Measures the rotation and change of the
// force from tick to tick while the HIP slides over one sphere, along a crease and around a pit. The HIP is 0.6 A deep
// and moves 0.02 A per tick.
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
  scenes::Path approach;  ///< from outside to the first counted position
  scenes::Path counted;
};

/// "one sphere", "crease", "pit".
std::vector<FeelPath> feelPaths();

struct Feel {
  std::string path;
  const Method* method = nullptr;
  Statistics turn_deg;  ///< rotation of the force's direction per tick
  Statistics change_A;  ///< of Contact::displacement_A per tick; times the stiffness, that of the force
  double lost = 0;      ///< fraction of ticks without contact
};

std::vector<Feel> measureFeel(const std::vector<const Method*>& methods);

ReportTable feelTable(const std::vector<Feel>& rows);

}  // namespace moltact::bench
