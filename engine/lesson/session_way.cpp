// Determines which steps of a lesson a student visits, and in which order.

#include <algorithm>

#include "engine/lesson/class_hold.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/session.h"

namespace moltact {

std::size_t LessonSession::mainStepAfter(std::size_t step) const {
  const std::vector<char> skipped = skippedSteps();
  do ++step;
  while (step < lesson_->steps.size() && (lesson_->steps[step].aside || skipped[step]));
  return step;
}

bool LessonSession::ruleHolds(std::size_t step, std::size_t question, std::size_t rule) const {
  const QuestionStatus& status = states_[step].questions[question];
  return lesson_->steps[step].questions[question].rules[rule].holds(status.attempts, status.answered_right);
}

// The steps that a rule names, and all between a question and the step to which its answer leads forward.
std::vector<char> LessonSession::skippedSteps() const {
  std::vector<char> out(lesson_->steps.size(), 0);
  for (std::size_t s = 0; s < lesson_->steps.size(); ++s)
    for (std::size_t q = 0; q < lesson_->steps[s].questions.size(); ++q)
      for (std::size_t r = 0; r < lesson_->steps[s].questions[q].rules.size(); ++r) {
        const StepRule& rule = lesson_->steps[s].questions[q].rules[r];
        if (!ruleHolds(s, q, r)) continue;
        for (const std::string& id : rule.steps) {
          const auto to = lesson_->find(id);
          if (!to) continue;
          if (rule.then == StepRule::Then::Skip)
            out[*to] = 1;
          else if (!lesson_->steps[*to].aside)
            for (std::size_t between = s + 1; between < *to; ++between) out[between] = 1;
        }
      }
  return out;
}

std::optional<std::size_t> LessonSession::leadsTo(std::size_t question) const {
  const QuestionStatus& status = state().questions[question];
  const std::vector<StepRule>& rules = step().questions[question].rules;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    if (rules[r].then != StepRule::Then::GoTo || !ruleHolds(step_, question, r)) continue;
    const auto to = rules[r].steps.empty() ? std::nullopt : lesson_->find(rules[r].steps[0]);
    if (!to || *to == step_) continue;
    const bool forward = *to > step_ && !lesson_->steps[*to].aside && !step().aside;
    // Rules that lead back or to an aside apply once: by the answer that triggered them, until the student has left the
    // step.
    const bool just_now = rules[r].when != StepRule::When::Wrong
                              ? status.last_right
                              : !status.answered_right && status.attempts == rules[r].wrong;
    if (forward || (just_now && !status.left_since_answer)) return to;
  }
  return std::nullopt;
}

std::optional<std::size_t> LessonSession::leadsTo() const {
  for (std::size_t q = 0; q < step().questions.size(); ++q)
    if (const auto to = leadsTo(q)) return to;
  return std::nullopt;
}

bool LessonSession::classWaits(std::size_t step) const {
  return !classHolds().empty() && !lesson_->steps[step].aside && classHolds(lessonName(lesson_->file).id, step);
}

bool LessonSession::waits(std::size_t step) const {
  if (classWaits(step)) return true;
  return lesson_->steps[step].required && !lesson_->steps[step].aside && !stepDone(step) &&
         !(step == step_ && leadsTo());
}

bool LessonSession::heldByClass() const {
  if (classHolds().empty()) return false;
  if (classWaits(step_)) return true;
  if (waits(step_)) return false;  // its own tasks come first
  // An answer may lead over the step where the class waits, or skip it.
  const std::size_t to = leadsTo().value_or(step().aside ? main_step_ : mainStepAfter(step_));
  return to < lesson_->steps.size() && !lesson_->steps[to].aside && to > main_step_ &&
         classHolds(lessonName(lesson_->file).id, to - 1);
}

bool LessonSession::mayGoOn() const { return !waits(step_) && !heldByClass(); }

bool LessonSession::mayGoTo(std::string_view link) const {
  if (link.starts_with('#')) link.remove_prefix(1);
  const auto to = lesson_->find(link);
  if (!to || lesson_->steps[*to].aside) return true;
  const std::vector<char> skipped = skippedSteps();
  for (std::size_t s = main_step_; s < *to; ++s)
    if (!skipped[s] && waits(s)) return false;
  return true;
}

bool LessonSession::hasNext() const {
  return step().aside || leadsTo() || mainStepAfter(step_) < lesson_->steps.size();
}

void LessonSession::next() {
  if (!hasNext() || !mayGoOn()) return;
  if (const auto to = leadsTo())
    enter(*to);
  else
    enter(step().aside ? main_step_ : mainStepAfter(step_));
}

void LessonSession::back() {
  if (!hasBack()) return;
  if (step().aside) return enter(main_step_);
  // The first step is not an aside, and no question precedes it, so it cannot be skipped.
  const std::vector<char> skipped = skippedSteps();
  std::size_t before = step_;
  do --before;
  while (before > 0 && (lesson_->steps[before].aside || skipped[before]));
  enter(before);
}

bool LessonSession::goTo(std::string_view link) {
  if (link.starts_with('#')) link.remove_prefix(1);
  const auto found = lesson_->find(link);
  if (found && *found != step_) enter(*found);
  return found.has_value();
}

std::vector<std::size_t> LessonSession::route() const {
  const std::vector<char> skipped = skippedSteps();
  std::vector<std::size_t> out;
  for (std::size_t s = 0; s < lesson_->steps.size(); ++s)
    if (!lesson_->steps[s].aside && (!skipped[s] || s == main_step_)) out.push_back(s);
  return out;
}

std::size_t LessonSession::numberOf(std::size_t step) const {
  const std::vector<std::size_t> counted = route();
  return static_cast<std::size_t>(std::find(counted.begin(), counted.end(), step) - counted.begin()) + 1;
}

}  // namespace moltact
