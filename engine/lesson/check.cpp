#include "engine/lesson/check.h"

#include "engine/lesson/checks.h"
#include "engine/lesson/reader.h"

namespace moltact {
LessonCheck checkLesson(const std::string& name, std::string bytes, const MoleculeByName& molecule) {
  LessonReading read = readLessonText(name, bytes);
  checks::Findings found{name, std::move(read.errors), std::move(read.warnings)};
  if (const Lesson* lesson = read.lesson ? &*read.lesson : read.partial ? &*read.partial : nullptr) {
    checks::molecules(*lesson, molecule, found);
    checks::guides(*lesson, molecule, found);
    checks::moleculeList(*lesson, found);
    checks::steps(*lesson, found);
    checks::ways(*lesson, found);
    checks::minutes(*lesson, found);
    checks::askedTwice(*lesson, found);
    checks::files(*lesson, name, found);
    checks::words(*lesson, name, found);
    checks::language(*lesson, name, found);
    checks::signs(bytes, found);
  }
  orderProblems(found.errors);
  orderProblems(found.warnings);
  return {std::move(read.lesson), std::move(found.errors), std::move(found.warnings)};
}

std::vector<Problem> checkAgainstMolecules(const Lesson& lesson, const MoleculeByName& molecule) {
  checks::Findings found{lesson.file, {}, {}};
  checks::molecules(lesson, molecule, found);
  orderProblems(found.errors);
  return std::move(found.errors);
}

}  // namespace moltact
