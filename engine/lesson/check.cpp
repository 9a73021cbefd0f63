#include "engine/lesson/check.h"

#include <algorithm>

#include "engine/lesson/checks.h"
#include "engine/lesson/reader.h"

namespace moltact {
namespace {

void sortByPlace(std::vector<Problem>& problems) {
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
}

}  // namespace

LessonCheck checkLesson(const std::string& name, std::string bytes, const MoleculeByName& molecule) {
  LessonReading read = readLessonText(name, std::move(bytes));
  checks::Findings found{name, std::move(read.errors), std::move(read.warnings)};
  if (const Lesson* lesson = read.lesson ? &*read.lesson : read.partial ? &*read.partial : nullptr) {
    checks::molecules(*lesson, molecule, found);
    checks::moleculeList(*lesson, found);
    checks::steps(*lesson, found);
    checks::files(*lesson, name, found);
  }
  sortByPlace(found.errors);
  sortByPlace(found.warnings);
  return {std::move(read.lesson), std::move(found.errors), std::move(found.warnings)};
}

std::vector<Problem> checkAgainstMolecules(const Lesson& lesson, const MoleculeByName& molecule) {
  checks::Findings found{lesson.file, {}, {}};
  checks::molecules(lesson, molecule, found);
  sortByPlace(found.errors);
  return std::move(found.errors);
}

}  // namespace moltact
