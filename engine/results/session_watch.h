// Turns changes in a lesson's session into events of an attempt, by comparing it with what it was at the last look.
// Window's thread, once a frame: cheap where nothing changed.
#pragma once

#include <vector>

#include "engine/lesson/session.h"
#include "engine/results/attempt.h"

namespace moltact {

class SessionWatch {
 public:
  /// Takes the session's present state as known: nothing of it becomes an event but the step where the student is.
  void begin(const LessonSession& session);

  /// The events since the last look. `by`: the input that led the probe and gave answers meanwhile.
  std::vector<AttemptEvent> look(const LessonSession& session, double t_s, InputKind by);

  /// As a line of the log tells it.
  static ProgressMade progressOf(const LessonSession& session);

 private:
  struct StepSeen {
    std::vector<char> tasks_done;
    std::vector<int> attempts;
    std::vector<std::vector<char>> rules;  // of each question, those that have come true
  };
  /// How far a task of the step has come with a curve.
  struct CurveSeen {
    bool drawing = true, compared = false;
  };
  void lookAtCurves(const LessonSession& session, double t_s, std::vector<AttemptEvent>& out);
  void resize(const Lesson& lesson);

  const Lesson* lesson_ = nullptr;
  std::vector<StepSeen> seen_;
  std::size_t step_ = ~std::size_t{0},
              task_ = ~std::size_t{0};  // the step and task under way; none: the largest number
  double task_begun_s_ = 0.0;
  std::vector<CurveSeen> curves_;  // of the step where the student is
};

}  // namespace moltact
