// Makes the packs and pages of a study from its plan. Any thread except the haptic one; blocks on downloads.
#pragma once

#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/pack/study_plan.h"

namespace moltact {

/// One pack (pack_file.h): the parts of a group in their order, or the delayed test.
struct StudyPack {
  std::string name;   ///< "grooves-2026-hands", "grooves-2026-delayed"
  std::string group;  ///< empty: for every group
  std::string bytes;
  std::vector<std::string> files;
};

struct StudyPacks {
  std::vector<StudyPack> packs;  ///< in the order of the groups, then the delayed test; only without errors
  std::vector<Problem> errors, warnings;
};

/// Every lesson and test is checked first. A lesson gets the group's condition, a place in the study and its position
/// in the order of the parts; so do its translations. Lessons to which it links get the condition.
StudyPacks packStudy(const StudyPlan& plan);

/// A student of a draw.
struct DrawnStudent {
  std::string code;
  std::size_t group = 0;  ///< index of the plan's groups
};
std::vector<DrawnStudent> drawStudents(const StudyPlan& plan);

/// The list for whoever leads the study: number, code, group and condition of each student. CSV.
std::string drawTable(const StudyPlan& plan, const std::vector<DrawnStudent>& students);

/// One page that asks for the code and opens the pack of the student's group. `page` as in pageWithPack().
Expected<std::string> pageWithDraw(std::string page, const std::string& page_file, const StudyPlan& plan,
                                   const std::vector<StudyPack>& packs, const std::vector<DrawnStudent>& students);

}  // namespace moltact
