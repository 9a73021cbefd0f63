// Checks a lesson as an author needs it: all faults that can be found at once, beyond its own text too: molecules that
// there are, selections that select atoms, links and pictures that are there, steps that can be reached. Not for the
// haptic thread.
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

/// The molecule of that name in the library, read as it says, or why it cannot be had.
using MoleculeByName = std::function<Expected<std::shared_ptr<const Molecule>>(const NamedMolecule& named)>;

struct LessonCheck {
  std::optional<Lesson> lesson;   ///< present where it could be read: a student could begin it, whatever `errors` says
  std::vector<Problem> errors;    ///< in the order of the file, each at its place in it
  std::vector<Problem> warnings;  ///< the same
};

/// Reads and checks a lesson. `name` is the path of its file: links and pictures are looked up in its folder.
/// Each molecule is asked for once. A text that cannot be read whole is checked as far as it was understood.
LessonCheck checkLesson(const std::string& name, std::string bytes, const MoleculeByName& molecule);

/// Only what the molecules tell of a lesson that was read: every error, in the order of the file.
std::vector<Problem> checkAgainstMolecules(const Lesson& lesson, const MoleculeByName& molecule);

}  // namespace moltact
