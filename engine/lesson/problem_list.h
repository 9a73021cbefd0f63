// The problems of a lesson that are reported; a person reads them from the top, so there is a greatest number. Any
// thread but the haptic one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/language/catalogue.h"

namespace moltact {

/// The problems of one lesson and one kind, errors or warnings; a last one says that there are more.
inline constexpr std::size_t kMaxLessonProblems = 500;

/// Whether another problem would not be reported any more, so that neither it nor its remedy need be sought.
inline bool enoughProblems(const std::vector<Problem>& problems) { return problems.size() > kMaxLessonProblems; }

/// Brings them into the order of the file, and cuts what is too many.
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
