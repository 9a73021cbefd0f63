#include "engine/results/translation_shape.h"

#include <algorithm>
#include <cstddef>

#include "engine/language/catalogue.h"
#include "engine/results/attempt.h"

namespace moltact {
namespace {

struct Difference {
  Place place;
  std::string message;
};

// The first difference within a step. `number`: of the step, from 1.
std::optional<Difference> inStep(std::size_t number, const Step& step, const StepOutline& is, const StepOutline& wanted,
                                 const std::string& lesson) {
  if (is.aside != wanted.aside)
    return Difference{step.place, is.aside
                                      ? trf("step {0} is no part of the core, but that of {1} is", number, lesson)
                                      : trf("step {0} is a part of the core, but that of {1} is not", number, lesson)};
  for (std::size_t k = 0; k < std::min(is.tasks.size(), wanted.tasks.size()); ++k)
    if (is.tasks[k].kind != wanted.tasks[k].kind)
      return Difference{step.tasks[k].place, trf("task {0} of step {1} is '{2}', that of {3} is '{4}'", k + 1, number,
                                                 is.tasks[k].kind, lesson, wanted.tasks[k].kind)};
  if (is.tasks.size() != wanted.tasks.size())
    return Difference{
        is.tasks.size() > wanted.tasks.size() ? step.tasks[wanted.tasks.size()].place : step.place,
        trf("step {0} has {1}, that of {2} has {3}", number,
            trnf("{0} task", "{0} tasks", is.tasks.size(), is.tasks.size()), lesson, wanted.tasks.size())};
  for (std::size_t k = 0; k < std::min(is.questions.size(), wanted.questions.size()); ++k) {
    const QuestionOutline &q = is.questions[k], &other = wanted.questions[k];
    if (q.kind != other.kind)
      return Difference{step.questions[k].place, trf("question {0} of step {1} is of another kind than that of {2}: of "
                                                     "marked, free and prediction",
                                                     k + 1, number, lesson)};
    if (q.choices.size() != other.choices.size())
      return Difference{
          step.questions[k].place,
          trf("question {0} of step {1} has {2}, that of {3} has {4}", k + 1, number,
              trnf("{0} choice", "{0} choices", q.choices.size(), q.choices.size()), lesson, other.choices.size())};
    if (q.right != other.right)
      return Difference{
          step.questions[k].place,
          trf("question {0} of step {1} has other right choices than that of {2}", k + 1, number, lesson)};
  }
  if (is.questions.size() != wanted.questions.size())
    return Difference{
        is.questions.size() > wanted.questions.size() ? step.questions[wanted.questions.size()].place : step.place,
        trf("step {0} has {1}, that of {2} has {3}", number,
            trnf("{0} question", "{0} questions", is.questions.size(), is.questions.size()), lesson,
            wanted.questions.size())};
  return std::nullopt;
}

}  // namespace

std::optional<Problem> translationFault(const Lesson& lesson, const std::string& lesson_file, const Lesson& translation,
                                        const std::string& translation_file) {
  const LessonOutline wanted = outlineOf(lesson, {}), is = outlineOf(translation, {});
  std::optional<Difference> found;
  const std::size_t both = std::min({is.steps.size(), wanted.steps.size(), translation.steps.size()});
  for (std::size_t k = 0; k < both && !found; ++k)
    found = inStep(k + 1, translation.steps[k], is.steps[k], wanted.steps[k], lesson_file);
  if (!found && is.steps.size() != wanted.steps.size())
    found =
        Difference{is.steps.size() > both ? translation.steps[both].place : Place{},
                   trf("it has {0}, but {1} has {2}", trnf("{0} step", "{0} steps", is.steps.size(), is.steps.size()),
                       lesson_file, wanted.steps.size())};
  if (!found) return std::nullopt;
  return Problem{translation_file, found->place.line, found->place.column, std::move(found->message),
                 tr("give the translation the same steps, tasks, questions and choices in the same order: the learning "
                    "platform counts all languages as one lesson")};
}

}  // namespace moltact
