// The parts of checkLesson(). Internal. Each adds its findings, in any order.
#pragma once

#include <filesystem>

#include "engine/lesson/check.h"
#include "engine/lesson/problem_list.h"

namespace moltact::checks {

struct Findings {
  std::string file;
  std::vector<Problem> errors, warnings;

  bool enough() const { return enoughProblems(errors); }
  void error(Place place, std::string message, std::string remedy) {
    if (!enough()) errors.push_back({file, place.line, place.column, std::move(message), std::move(remedy)});
  }
  void warning(Place place, std::string message, std::string remedy) {
    if (!enoughProblems(warnings))
      warnings.push_back({file, place.line, place.column, std::move(message), std::move(remedy)});
  }
};

/// Missing molecules, and selections and names that match no atom.
void molecules(const Lesson& lesson, const MoleculeByName& molecule, Findings& findings);

/// Guides without a way: a recorded hand that cannot be read, a task's way that the probe cannot go, atoms that move.
void guides(const Lesson& lesson, const MoleculeByName& molecule, Findings& findings);

/// Molecules in the front matter that no scene uses or that are listed twice.
void moleculeList(const Lesson& lesson, Findings& findings);

/// Asides without a link, and empty steps.
void steps(const Lesson& lesson, Findings& findings);

/// Rules that never apply or lead to unreachable steps; required steps without tasks and questions.
void ways(const Lesson& lesson, Findings& findings);

/// Stated minutes that differ from the estimate; a core that takes too long.
void minutes(const Lesson& lesson, Findings& findings);

/// A task asked before and after: both must exist in the core and ask the same.
void askedTwice(const Lesson& lesson, Findings& findings);

/// Links to missing files and pictures, pictures that cannot be shown, and links to missing steps of other lessons.
void files(const Lesson& lesson, const std::filesystem::path& lesson_file, Findings& findings);

/// Links to words that neither the lesson nor its folder's glossary explains.
void words(const Lesson& lesson, const std::filesystem::path& lesson_file, Findings& findings);

/// A file name whose ending looks like a language but is none, or that contradicts the front matter.
void language(const Lesson& lesson, const std::filesystem::path& lesson_file, Findings& findings);

/// Characters that the window cannot display, line by line.
void signs(std::string_view text, Findings& findings);

}  // namespace moltact::checks
