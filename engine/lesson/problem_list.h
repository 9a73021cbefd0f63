// Limits the number of reported problems of a lesson, because a person reads them from the top. Any thread but the
// haptic one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/language/catalogue.h"

namespace moltact {

/// The maximum length of each list of one lesson, errors and warnings. A further entry says that more exist.
inline constexpr std::size_t kMaxLessonProblems = 500;

/// Whether further problems would not be reported, so that neither they nor their remedies need be computed.
inline bool enoughProblems(const std::vector<Problem>& problems) { return problems.size() > kMaxLessonProblems; }

/// Sorts them by their place in the file and removes those beyond the maximum.
inline void orderProblems(std::vector<Problem>& problems) {
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  if (!enoughProblems(problems)) return;
  problems.resize(kMaxLessonProblems);
  Problem last = problems.back();
  last.message = tr("there are more, which are not listed");
  last.remedy = tr("mend these first");
  problems.push_back(std::move(last));
}

}  // namespace moltact
