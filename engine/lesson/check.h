// Checks a lesson for its author. Finds all faults at once, also beyond the lesson's text: missing molecules,
// selections without atoms, broken links and pictures, steps that cannot be reached. Not for the haptic thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Returns the library's molecule of that name, read as `named` says, or why it is not available.
using MoleculeByName = std::function<Expected<std::shared_ptr<const Molecule>>(const NamedMolecule& named)>;

struct LessonCheck {
  std::optional<Lesson> lesson;   ///< present if the text could be read: a student can begin it even if `errors` is not
                                  ///< empty
  std::vector<Problem> errors;    ///< in the order of the file, each with its place
  std::vector<Problem> warnings;  ///< the same
};

/// Reads and checks a lesson. `name` is the path of its file; links and pictures are looked up in its folder. Each
/// molecule is requested once. Of a text with errors, the part that was understood is checked.
LessonCheck checkLesson(const std::string& name, std::string bytes, const MoleculeByName& molecule);

/// Only the checks of a lesson against its molecules: every error, in the order of the file.
std::vector<Problem> checkAgainstMolecules(const Lesson& lesson, const MoleculeByName& molecule);

/// Computes the facts that the lesson states from its molecules and returns the false ones, in the order of the file.
/// Their searches may take seconds: for `moltact check`, not for a window.
std::vector<Problem> checkFacts(const Lesson& lesson, const MoleculeByName& molecule);

}  // namespace moltact
