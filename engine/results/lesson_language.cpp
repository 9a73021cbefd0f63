#include "engine/results/lesson_language.h"

#include <algorithm>

#include "engine/lesson/lesson_files.h"

namespace moltact {
namespace {

bool sameShape(const LessonOutline& a, const LessonOutline& b) {
  const auto same_questions = [](const QuestionOutline& p, const QuestionOutline& q) {
    return p.choices.size() == q.choices.size() && p.kind == q.kind;
  };
  const auto same_tasks = [](const TaskOutline& p, const TaskOutline& q) { return p.kind == q.kind; };
  return std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(),
                    [&](const StepOutline& p, const StepOutline& q) {
                      return p.aside == q.aside &&
                             std::equal(p.tasks.begin(), p.tasks.end(), q.tasks.begin(), q.tasks.end(), same_tasks) &&
                             std::equal(p.questions.begin(), p.questions.end(), q.questions.begin(), q.questions.end(),
                                        same_questions);
                    });
}

}  // namespace

bool sameLesson(const LessonOutline& a, const LessonOutline& b) {
  if (a.file == b.file) return a.title == b.title;
  return lessonName(a.file).id == lessonName(b.file).id && sameShape(a, b);
}

Attempt inTermsOf(const LessonOutline& target, Attempt attempt) {
  if (attempt.header.lesson.file == target.file && attempt.header.lesson.hash == target.hash) return attempt;
  LessonOutline now = attempt.header.lesson;
  const auto stepAt = [&](const std::string& id) {
    return std::size_t(
        std::find_if(now.steps.begin(), now.steps.end(), [&](const StepOutline& s) { return s.id == id; }) -
        now.steps.begin());
  };
  const auto rename = [&](auto& event) {
    if constexpr (requires { event.step; }) {
      const std::size_t s = stepAt(event.step);
      if (now.file == target.file || s >= now.steps.size() || s >= target.steps.size()) return;
      if constexpr (requires { event.question; }) {
        const std::vector<QuestionOutline>& of = now.steps[s].questions;
        const auto q = std::size_t(
            std::find_if(of.begin(), of.end(), [&](const QuestionOutline& o) { return o.id == event.question; }) -
            of.begin());
        if (q < of.size() && q < target.steps[s].questions.size()) event.question = target.steps[s].questions[q].id;
      }
      event.step = target.steps[s].id;
    }
  };
  if (sameLesson(now, target) && now.file != target.file) attempt.header.lesson = target;
  for (AttemptEvent& event : attempt.events) {
    std::visit(rename, event.what);
    auto* reread = std::get_if<LessonReread>(&event.what);
    if (!reread) continue;
    now = reread->lesson;
    if (now.file != target.file && sameLesson(now, target)) reread->lesson = target;
  }
  return attempt;
}

}  // namespace moltact
