// Adds the events of a session.

#include "engine/lesson/session_events.h"

#include <utility>

#include "engine/lesson/session.h"

namespace moltact {

std::vector<SessionEvent> LessonSession::takeEvents() { return std::exchange(events_, {}); }

void LessonSession::restartEvents() {
  events_.clear();
  reportStep();
}

void LessonSession::reportStep() {
  while (!events_.empty() &&
         (std::holds_alternative<StepShown>(events_.back()) || std::holds_alternative<TaskStarted>(events_.back())))
    events_.pop_back();
  events_.push_back(StepShown{step().id});
  reported_task_.reset();
  reportTask();
}

void LessonSession::reportTask() {
  const std::size_t current = currentTask();
  if (reported_task_ == current) return;
  reported_task_ = current;
  dropStartedTask();
  if (current < step().tasks.size()) events_.push_back(TaskStarted{step().id, current});
}

void LessonSession::dropStartedTask() {
  if (!events_.empty() && std::holds_alternative<TaskStarted>(events_.back())) events_.pop_back();
}

void LessonSession::reportFinished(std::size_t task) {
  if (reported_task_ == task) dropStartedTask();
  events_.push_back(TaskFinished{step().id, task, taskSolved(step_, task), taskFigures(task)});
  reportTask();
}

LessonSession::CurveState LessonSession::curveState(const Task& task) {
  const TaskCurves* curves = task.curves();
  return curves ? CurveState{curves->drawing, curves->agreement.has_value() || curves->complete} : CurveState();
}

void LessonSession::reportCurves(std::size_t task, CurveState before) {
  const CurveState now = curveState(*tasks_[task]);
  const auto report = [&](bool felt) {
    const TaskCurves& c = *tasks_[task]->curves();
    events_.push_back(CurveKnown{step().id, task, felt, c.x_name, c.x_max_A, c.max_N, felt ? c.felt : c.drawn});
  };
  if (before.drawing && !now.drawing) report(false);
  if (now.compared && !before.compared) report(true);
}

void LessonSession::reportAnswer(std::size_t question, bool done_before, const std::vector<char>& rules_before) {
  const Question& asked = step().questions[question];
  const QuestionStatus& status = this->question(question);
  events_.push_back(AnswerJudged{step().id, asked.id, status.attempts, status.chosen, status.written, status.last_right,
                                 status.done() && !done_before});
  for (std::size_t r = 0; r < asked.rules.size(); ++r) {
    const StepRule& rule = asked.rules[r];
    if (!rules_before[r] && ruleHolds(step_, question, r))
      events_.push_back(RuleApplied{step().id, asked.id, rule.key(), rule.then == StepRule::Then::Skip, rule.steps});
  }
}

void LessonSession::openHints(std::size_t count) {
  for (; hints_ < count; ++hints_) events_.push_back(HintOpen{step().id, hints_ + 1});
  hints_ = count;
}

}  // namespace moltact
