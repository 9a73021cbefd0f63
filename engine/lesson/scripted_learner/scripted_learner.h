// A scripted learner: works through a lesson without a window on a virtual clock, does its tasks by their plans or by a
// script, answers its questions and reports events. For tests and for authors. Any one thread but the haptic one. The
// same lesson and molecules give the same events.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/lesson/check.h"
#include "engine/lesson/scripted_learner/virtual_touch.h"
#include "engine/lesson/session.h"

namespace moltact {

/// An event of the learner's work.
struct LearnerEvent {
  enum class Kind {
    Step,      ///< a step was entered; `text` is its title, `note` its molecule
    Task,      ///< a task was done; `text` is its instruction, `note` its final sentence
    GaveUp,    ///< a task was not done in the time available; `note` is its last sentence
    Question,  ///< a question was answered; `text` is the question, `answer` the answer, `note` the feedback
    Fault,     ///< the step could not be continued; `note` is the reason
  };
  Kind kind = Kind::Step;
  double time_s = 0.0;    ///< on the virtual clock
  std::string step;       ///< id of the step
  std::size_t index = 0;  ///< of the step in the lesson, or of the task or question in its step
  std::string text, note, answer;
  bool right = false;  ///< of a question
  bool taken = true;   ///< of a question: the answer counts; false: it was rejected, and `note` is the reason
  std::vector<TaskFigure> figures;  ///< of a task
  Place place;                      ///< in the lesson's file
};

class ScriptedLearner {
 public:
  using Watch = std::function<void(const LearnerEvent&)>;

  struct Options {
    double task_s = 180.0;  ///< time on the virtual clock after which a task is given up
    int attempts = 12;      ///< number of successive plans without progress after which a task is given up
  };

  /// Positions the learner before the first step. `lesson` must not be null.
  ScriptedLearner(std::shared_ptr<const Lesson> lesson, MoleculeByName molecules, Watch watch, Options options);
  ScriptedLearner(std::shared_ptr<const Lesson> lesson, MoleculeByName molecules, Watch watch)
      : ScriptedLearner(std::move(lesson), std::move(molecules), std::move(watch), Options()) {}

  const LessonSession& session() const { return session_; }
  double time_s() const { return touch_.time_s(); }

  /// Loads the molecule of the session's step, unless that step was already entered. Returns false if there is none.
  bool enterStep();
  /// Does the current task by its plan. Returns true if the step has one and it was done.
  bool doTask();
  /// Gives the right answer to a question of the step: all right choices, the number or the first of the words; for a
  /// free question, a sentence.
  void answerCorrectly(std::size_t question);
  /// Answers a question with choices by their index, or with text.
  void choose(std::size_t question, const std::vector<std::size_t>& choices);
  void write(std::size_t question, const std::string& text);
  void next();
  void back();
  /// Returns false if there is no such step, or another must be finished first.
  bool goTo(const std::string& step);

  /// Does all tasks and questions from the present step to the last one. Returns true if the lesson was finished.
  bool demonstrate();
  /// Does the tasks and questions of every step not yet seen: asides, extra steps, and steps skipped by right answers.
  void demonstrateStepsLeft();

  /// Follows a plan and stops as soon as the task is done. The step must have been entered.
  void follow(const HandPlan& plan);
  /// The input for plans at the present state.
  HandPlanInput view(int attempt = 0) const { return touch_.view(attempt); }
  /// Gives an answer to the current task.
  void tell(const TaskAnswer& answer);

 private:
  void demonstrateStep();
  void tick(const PoseA& hand);
  bool timeIsUp() const;
  void reportDone(std::size_t task);
  void reportAnswer(std::size_t question, const std::string& answer, bool right, int attempts_before);
  LearnerEvent event(LearnerEvent::Kind kind) const;

  LessonSession session_;
  MoleculeByName by_name_;
  Watch watch_;
  Options options_;
  VirtualTouch touch_;
  std::size_t entered_ = ~std::size_t{0};  // index of the entered step's scene
  bool on_stage_ = false;
  double task_begun_s_ = 0.0;
};

}  // namespace moltact
