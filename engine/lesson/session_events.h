// The events of a lesson's session: what the student did, and the results. LessonSession adds them as they happen;
// attempts, the lesson's panel and extensions process them. Plain data; window's thread. Steps and questions are
// identified by ids, so that an event remains valid when the lesson is read again.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/lesson/tasks/task.h"

namespace moltact {

/// The student has entered this step. A step that is left before the events are taken was never displayed and gives
/// none.
struct StepShown {
  std::string step;
};
/// The student has reached this task of the step. As with steps, a task that is done before the events are taken gives
/// none.
struct TaskStarted {
  std::string step;
  std::size_t task = 0;
};
/// A task is solved, or its tries are used up and the answer is shown.
struct TaskFinished {
  std::string step;
  std::size_t task = 0;
  bool solved = false;  ///< false: the tries are used up
  std::vector<TaskFigure> figures;
};
/// A force curve of a task: the drawn one when it is submitted, or the felt one when both are known.
struct CurveKnown {
  std::string step;
  std::size_t task = 0;
  bool felt = false;
  std::string_view x_name;      ///< "depth"
  double x_max_A = 0.0;         ///< end of the axis, which begins at 0
  double max_N = 0.0;           ///< end of the force axis
  std::vector<double> force_N;  ///< at equal distances; NaN where nothing is known
};
/// An attempt at a question has been judged.
struct AnswerJudged {
  std::string step, question;
  int attempt = 0;                  ///< from 1
  std::vector<std::size_t> chosen;  ///< choices, ascending
  std::string written;
  bool right = false;
  /// the first answer after which the question is closed: right, not assessed, or the last try
  bool completes = false;
};
/// An answer has changed the order of the steps.
struct RuleApplied {
  std::string step, question;
  std::string rule;                ///< the author's text: "after 2 wrong"
  bool skips = false;              ///< false: leads to `steps`
  std::vector<std::string> steps;  ///< ids
};
/// Another hint of the step was opened.
struct HintOpen {
  std::string step;
  std::size_t number = 0;  ///< from 1
};

using SessionEvent =
    std::variant<StepShown, TaskStarted, TaskFinished, CurveKnown, AnswerJudged, RuleApplied, HintOpen>;

}  // namespace moltact
