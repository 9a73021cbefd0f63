#include "engine/results/attempt_ranges.h"

#include <array>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/touch_setup.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {
namespace {

constexpr double kYear_s = 366.0 * 86400.0;
constexpr double kBeyond_A = 2.0 * kMaxPosition_A;  // a margin beyond the farthest position of a hand
constexpr double kMax_N = 1000.0;                   // many times the peak force of any device
constexpr double kMaxAtoms = 2147483647.0;

constexpr std::array kRanges{
    // time
    AttemptRange{"t", -60.0, kYear_s},  // a tick may be a frame older than the attempt
    AttemptRange{"from", -60.0, kYear_s},
    AttemptRange{"took_s", 0.0, kYear_s},
    AttemptRange{"ms", 0.0, 1000.0 * kYear_s},
    // force
    AttemptRange{"peak_N", 0.0, kMax_N},
    AttemptRange{"mean_N", 0.0, kMax_N},
    AttemptRange{"most_N", 0.0, kMax_N},
    AttemptRange{"force_N", -kMax_N, kMax_N},
    AttemptRange{"force", -kMax_N, kMax_N},
    // place
    AttemptRange{"hip", -kBeyond_A, kBeyond_A},
    AttemptRange{"scp", -kBeyond_A, kBeyond_A},
    AttemptRange{"displacement", -2.0 * kBeyond_A, 2.0 * kBeyond_A},
    AttemptRange{"centre_A", -kBeyond_A, kBeyond_A},
    AttemptRange{"target_A", -kBeyond_A, kBeyond_A},
    AttemptRange{"distance_A", 0.1, 1e8},
    AttemptRange{"path_A", 0.0, 1e10},
    AttemptRange{"to_A", 0.0, 1e6},
    AttemptRange{"A_per_mm", 1e-4, 1e4},
    AttemptRange{"turn", -1.001, 1.001},
    AttemptRange{"orientation", -1.001, 1.001},
    AttemptRange{"body", -kBeyond_A, kBeyond_A},
    AttemptRange{"body_orientation", -1.001, 1.001},
    // counts and indices
    AttemptRange{"format", 1.0, kMaxAtoms, true},
    AttemptRange{"attempt", 1.0, 1e6, true},
    AttemptRange{"task", 0.0, 1e6, true},
    AttemptRange{"chosen", 0.0, 1e6, true},
    AttemptRange{"right", 0.0, 1e6, true},
    AttemptRange{"goals", 0.0, 1e6, true},
    AttemptRange{"done", 0.0, 1e6, true},
    AttemptRange{"of", 0.0, 1e6, true},
    AttemptRange{"crossings", 0.0, 1e10, true},
    AttemptRange{"lines", 1.0, 1e15, true},
    AttemptRange{"atoms", -1.0, kMaxAtoms, true},
    AttemptRange{"held", 0.0, kMaxAtoms, true},
    AttemptRange{"share", 0.0, 1.0},
    // a mover's own parameter
    AttemptRange{"position", -1e12, 1e12},
    // any measurement of a task
    AttemptRange{"value", -1e9, 1e9},
};

// Adds the ranges of the touch properties and of the reading options.
std::vector<AttemptRange> allRanges() {
  std::vector<AttemptRange> out(kRanges.begin(), kRanges.end());
  for (const TouchProperty& p : touchProperties())
    if (std::holds_alternative<double TouchSetup::*>(p.member))
      out.push_back({p.field, p.in_files.min, p.in_files.max});
  for (const ReadingOption& option : readingOptions())
    if (std::holds_alternative<int ReadOptions::*>(option.member))
      out.push_back({option.name, 1.0, kMaxReadNumber, true});
  return out;
}

}  // namespace

const AttemptRange* attemptRange(std::string_view key) {
  static const std::vector<AttemptRange> ranges = allRanges();
  for (const AttemptRange& range : ranges)
    if (range.key == key) return &range;
  return nullptr;
}

}  // namespace moltact
