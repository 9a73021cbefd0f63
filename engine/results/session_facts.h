// Converts the events of a lesson's session to those of an attempt. Window's thread.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "engine/lesson/session.h"
#include "engine/results/attempt.h"

namespace moltact {

class SessionFacts {
 public:
  /// `t_s`: the time of use at which the event happened. `by`: the input that led the probe or gave the answer.
  AttemptEvent factOf(const SessionEvent& event, double t_s, InputKind by);

  /// The student's progress.
  static ProgressMade progressOf(const LessonSession& session);
  /// Whether the event can change the progress.
  static bool changesProgress(const SessionEvent& event) { return !std::holds_alternative<HintOpen>(event); }

 private:
  struct Task {
    std::string step;
    std::size_t task = 0;
    double begun_s = 0.0;
  };
  std::optional<Task> under_way_;
};

}  // namespace moltact
