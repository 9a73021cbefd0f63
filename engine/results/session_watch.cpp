#include "engine/results/session_watch.h"

#include <algorithm>

namespace moltact {
namespace {
constexpr std::size_t kNone = ~std::size_t{0};
}

void SessionWatch::resize(const Lesson& lesson) {
  lesson_ = &lesson;
  seen_.assign(lesson.steps.size(), {});
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    seen_[i].tasks_done.assign(lesson.steps[i].tasks.size(), 0);
    seen_[i].attempts.assign(lesson.steps[i].questions.size(), 0);
    seen_[i].rules.clear();
    for (const Question& q : lesson.steps[i].questions) seen_[i].rules.emplace_back(q.rules.size(), 0);
  }
}

void SessionWatch::begin(const LessonSession& session) {
  resize(session.lesson());
  step_ = task_ = kNone;
  curves_.clear();
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    for (std::size_t t = 0; t < seen_[s].tasks_done.size(); ++t) seen_[s].tasks_done[t] = session.taskDone(s, t);
    for (std::size_t q = 0; q < seen_[s].attempts.size(); ++q) {
      seen_[s].attempts[q] = session.question(s, q).attempts;
      for (std::size_t r = 0; r < seen_[s].rules[q].size(); ++r) seen_[s].rules[q][r] = session.ruleHolds(s, q, r);
    }
  }
}

std::vector<AttemptEvent> SessionWatch::look(const LessonSession& session, double t_s, InputKind by) {
  std::vector<AttemptEvent> out;
  const Lesson& lesson = session.lesson();
  if (&lesson == lesson_ && session.stepIndex() == step_) lookAtCurves(session, t_s, out);
  // A lesson that was read again kept what it could.
  if (&lesson != lesson_) begin(session);
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    const Step& step = lesson.steps[s];
    for (std::size_t q = 0; q < step.questions.size(); ++q) {
      const QuestionStatus& status = session.question(s, q);
      if (status.attempts > seen_[s].attempts[q])
        out.push_back({t_s, Answered{step.id, step.questions[q].id, status.attempts, status.chosen, status.written,
                                     status.last_right, by}});
      if (status.attempts == seen_[s].attempts[q]) continue;
      seen_[s].attempts[q] = status.attempts;
      for (std::size_t r = 0; r < seen_[s].rules[q].size(); ++r) {
        const StepRule& rule = step.questions[q].rules[r];
        const bool holds = session.ruleHolds(s, q, r);
        if (holds && !seen_[s].rules[q][r])
          out.push_back({t_s, RuleApplied{step.id, step.questions[q].id, rule.key(), rule.then == StepRule::Then::Skip,
                                          rule.steps}});
        seen_[s].rules[q][r] = holds;
      }
    }
    for (std::size_t t = 0; t < step.tasks.size(); ++t) {
      const bool done = session.taskDone(s, t);
      if (done && !seen_[s].tasks_done[t]) {
        const bool timed = s == step_ && t == task_;
        TaskDone fact{step.id, t, timed ? t_s - task_begun_s_ : 0.0, by, {}, session.taskSolved(s, t)};
        for (const TaskFigure& f : session.figuresOf(s, t))
          fact.figures.push_back({std::string(f.name), f.value, std::string(f.unit)});
        out.push_back({t_s, std::move(fact)});
      }
      seen_[s].tasks_done[t] = done;
    }
  }
  if (session.stepIndex() != step_) {
    step_ = session.stepIndex();
    task_ = kNone;
    curves_.clear();
    out.push_back({t_s, StepEntered{session.step().id}});
  }
  const std::size_t tasks = session.step().tasks.size();
  std::size_t current = 0;
  while (current < tasks && session.taskDone(step_, current)) ++current;
  if (current == tasks) current = kNone;
  if (current != task_) {
    task_ = current;
    task_begun_s_ = t_s;
    if (current != kNone) out.push_back({t_s, TaskBegun{session.step().id, current}});
  }
  return out;
}

// A curve is told when it is handed in, and again as it was felt when both are known.
void SessionWatch::lookAtCurves(const LessonSession& session, double t_s, std::vector<AttemptEvent>& out) {
  curves_.resize(session.step().tasks.size());
  for (std::size_t t = 0; t < curves_.size(); ++t) {
    const Task* task = session.taskAt(t);
    const TaskCurves* now = task ? task->curves() : nullptr;
    CurveSeen& before = curves_[t];
    const CurveSeen seen = now ? CurveSeen{now->drawing, now->agreement.has_value()} : CurveSeen();
    const auto tell = [&](bool felt, const std::vector<double>& force_N) {
      out.push_back(
          {t_s, CurveKept{session.step().id, t, felt, std::string(now->x_name), now->x_max_A, now->max_N, force_N}});
    };
    if (before.drawing && !seen.drawing) tell(false, now->drawn);
    if (seen.compared && !before.compared) tell(true, now->felt);
    before = seen;
  }
}

ProgressMade SessionWatch::progressOf(const LessonSession& session) {
  const LessonSession::Parts parts = session.parts();
  return {session.step().id, parts.done, parts.of};
}

}  // namespace moltact
