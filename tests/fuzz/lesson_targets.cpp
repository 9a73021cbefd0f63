// Lessons, selections of atoms and files of answers.
#include "engine/lesson/check.h"
#include "engine/lesson/problem_list.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/answers_file.h"
#include "engine/lesson/selection.h"
#include "tests/fuzz/target.h"
#include "tests/lesson/small_molecules.h"

namespace moltact::fuzz {

void lesson(std::string_view bytes) {
  static const auto molecule = std::make_shared<const Molecule>(mixedMolecule());
  const LessonCheck check =
      checkLesson("/nowhere/x.md", std::string(bytes),
                  [](const NamedMolecule& molecule_named) -> Expected<std::shared_ptr<const Molecule>> {
                    if (molecule_named.name.size() > 6)
                      return Problem{{}, 0, 0, "there is no such molecule", "take another"};
                    return molecule;
                  });
  mustBe(check.lesson || !check.errors.empty(), "a lesson or an error");
  mustBe(check.errors.size() <= kMostLessonProblems + 1 && check.warnings.size() <= kMostLessonProblems + 1,
         "no more problems than are told");
  for (const Problem& p : check.errors) mustBe(!p.message.empty(), "a message");
  if (check.lesson)
    mustBe(!check.lesson->steps.empty() && check.lesson->steps.size() <= kMostLessonSteps, "1 to 1000 steps");
}

void selection(std::string_view bytes) {
  static const Molecule molecule = mixedMolecule();
  const auto read = parseSelection(bytes);
  if (!read) return mustBe(!read.problem().message.empty(), "a message");
  const std::vector<std::uint32_t> atoms = read->select(molecule);
  for (std::size_t i = 0; i < atoms.size(); ++i)
    mustBe(atoms[i] < molecule.atoms.size() && (i == 0 || atoms[i - 1] < atoms[i]), "atoms that are there, ascending");
  if (atoms.empty())
    mustBe(!read->whyEmpty(molecule).message.empty(), "a reason");
  else
    read->idleNames(molecule);
  mustBe(!read->noun().empty(), "a noun");
}

void answers(std::string_view bytes) {
  for (const Problem& p : readAnswers("x.txt", bytes).problems)
    mustBe(!p.message.empty() && p.line > 0, "a message and its line");
}

}  // namespace moltact::fuzz
