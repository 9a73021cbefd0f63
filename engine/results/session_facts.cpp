#include "engine/results/session_facts.h"

namespace moltact {

AttemptEvent SessionFacts::factOf(const SessionEvent& event, double t_s, InputKind by) {
  const auto convert = [&]<typename T>(const T& e) -> AttemptFact {
    if constexpr (std::is_same_v<T, StepShown>) {
      under_way_.reset();
      return StepEntered{e.step};
    } else if constexpr (std::is_same_v<T, TaskStarted>) {
      under_way_ = {e.step, e.task, t_s};
      return TaskBegun{e.step, e.task};
    } else if constexpr (std::is_same_v<T, TaskFinished>) {
      const bool timed = under_way_ && under_way_->step == e.step && under_way_->task == e.task;
      TaskDone fact{e.step, e.task, timed ? t_s - under_way_->begun_s : 0.0, by, {}, e.solved};
      for (const TaskFigure& f : e.figures) fact.figures.push_back({std::string(f.name), f.value, std::string(f.unit)});
      return fact;
    } else if constexpr (std::is_same_v<T, CurveKnown>) {
      return CurveKept{e.step, e.task, e.felt, std::string(e.x_name), e.x_max_A, e.max_N, e.force_N};
    } else if constexpr (std::is_same_v<T, AnswerJudged>) {
      return Answered{e.step, e.question, e.attempt, e.chosen, e.written, e.right, by};
    } else if constexpr (std::is_same_v<T, RuleApplied>) {
      return OrderChanged{e.step, e.question, e.rule, e.skips, e.steps};
    } else {
      static_assert(std::is_same_v<T, HintOpen>);
      return HintOpened{e.step};
    }
  };
  return {t_s, std::visit(convert, event)};
}

ProgressMade SessionFacts::progressOf(const LessonSession& session) {
  const LessonSession::Parts parts = session.parts();
  return {session.step().id, parts.done, parts.of};
}

}  // namespace moltact
