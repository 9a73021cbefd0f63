// The plan of a study: front matter like that of a lesson, and prose below it for its readers (docs/study.md). Any thread
// except the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/keys.h"
#include "engine/lesson/lesson.h"

namespace moltact {

struct PlannedLesson {
  std::filesystem::path file;
  Place place;  ///< where the plan names it
};

struct PlannedGroup {
  std::string name;
  Condition condition = Condition::Touch;
  std::vector<PlannedLesson> lessons;  ///< at least one
};

struct StudyPlan {
  std::string file, title;
  std::string study;                                ///< its name: letters, digits and hyphens
  std::optional<PlannedLesson> pre, post, delayed;  ///< tests
  std::vector<PlannedGroup> groups;                 ///< at least one
  std::string ask = "code";                         ///< as in a lesson
  bool draws = false;                               ///< one page assigns the students
  std::size_t students = 0, block = 0;              ///< of the draw; `block` is a multiple of the number of groups
  std::uint64_t seed = 0;
};

struct StudyPlanReading {
  std::optional<StudyPlan> plan;  ///< present exactly if there are no errors
  std::vector<Problem> errors;
};

/// Reads a plan. Lessons and tests are searched in the plan's folder, in `assets/studies` and in `lessons` of the program.
StudyPlanReading readStudyPlan(const std::filesystem::path& file);

/// The keys of a plan.
const std::vector<KeySpec>& studyPlanKeys();

}  // namespace moltact
