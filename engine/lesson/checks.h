// The parts of checkLesson. Internal. Each adds what it finds, in any order.
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

/// Molecules that there are not, selections without atoms, names that select none.
void molecules(const Lesson& lesson, const MoleculeByName& molecule, Findings& findings);

/// Molecules of the front matter that no scene uses, or that it lists twice.
void moleculeList(const Lesson& lesson, Findings& findings);

/// Asides that no step leads to; steps without a word.
void steps(const Lesson& lesson, Findings& findings);

/// Rules that never come true, or lead where nobody is going; steps that must be finished and have nothing to finish.
void ways(const Lesson& lesson, Findings& findings);

/// Minutes that the author states and that do not follow from the lesson; a core that takes too long.
void minutes(const Lesson& lesson, Findings& findings);

/// A task that is asked before and after: both are there, in the core, and ask the same.
void askedTwice(const Lesson& lesson, Findings& findings);

/// Links to files and pictures that are not in the lesson's folder, pictures that cannot be shown; links into other lessons whose step is not there.
void files(const Lesson& lesson, const std::filesystem::path& lesson_file, Findings& findings);

/// Links to words that neither the lesson nor the glossary beside it explains.
void words(const Lesson& lesson, const std::filesystem::path& lesson_file, Findings& findings);

/// A file's name that ends as if it named a language and does not; one that the front matter contradicts.
void language(const Lesson& lesson, const std::filesystem::path& lesson_file, Findings& findings);

/// Characters that the window cannot write, line by line of the file's text.
void signs(std::string_view text, Findings& findings);

}  // namespace moltact::checks
