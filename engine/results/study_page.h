// The report on a study as one web page that works offline, with tables, SVG plots, each formula and its reference. Any
// thread but the haptic one.
#pragma once

#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/study_data.h"

namespace moltact {

/// One comparison of two groups in one outcome.
struct StudyComparison {
  std::string outcome;  ///< "gain", "post", "delayed gain"
  std::string first, second;
  std::optional<EffectSize> effect;  ///< first minus second, in shares of the test
  std::size_t n1 = 0, n2 = 0;
};
/// Every pair of groups, those with touch first, in each outcome that the study has. Outcomes are the gain from pre to
/// post, the test after, and the gain to the delayed test.
std::vector<StudyComparison> studyComparisons(const StudyData& study);

/// Returns the whole file; `made` is the date in words.
std::string studyPage(const StudyData& study, const std::vector<Problem>& passed_over, const std::string& made);

}  // namespace moltact
