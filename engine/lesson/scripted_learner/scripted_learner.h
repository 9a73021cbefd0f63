// A scripted learner, who goes through a lesson without a window and on a virtual clock: does its tasks as each kind
// shows how, or as a script says, answers its questions, and tells what happened. For tests and for authors. One
// thread, not the haptic one. The same lesson and molecules give the same events.
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

/// Something that happened on the way.
struct LearnerEvent {
  enum class Kind {
    Step,      ///< a step was entered; `text` is its title, `note` its molecule
    Task,      ///< a task was done; `text` is what it asked, `note` what it said then
    GaveUp,    ///< a task was not done in the time there is; `note` is what it said last
    Question,  ///< a question was answered; `text` is the question, `answer` the answer, `note` the feedback
    Fault,     ///< nothing could be done; `note` says why
  };
  Kind kind = Kind::Step;
  double time_s = 0.0;    ///< on the virtual clock
  std::string step;       ///< id of the step
  std::size_t index = 0;  ///< of the step in the lesson, or of the task or question in the step
  std::string text, note, answer;
  bool right = false;  ///< of a question
  bool taken = true;   ///< of a question: the answer counts; false: nothing came of it, and `note` says why
  std::vector<TaskFigure> figures;  ///< of a task
  Place place;                      ///< in the lesson's file
};

class ScriptedLearner {
 public:
  using Watch = std::function<void(const LearnerEvent&)>;

  struct Options {
    double task_s = 180.0;  ///< so long a task is tried on the virtual clock
    int attempts = 12;      ///< so many plans in a row that bring a task no further
  };

  /// Stands before the first step. `lesson` must not be null.
  ScriptedLearner(std::shared_ptr<const Lesson> lesson, MoleculeByName molecules, Watch watch, Options options);
  ScriptedLearner(std::shared_ptr<const Lesson> lesson, MoleculeByName molecules, Watch watch)
      : ScriptedLearner(std::move(lesson), std::move(molecules), std::move(watch), Options()) {}

  const LessonSession& session() const { return session_; }
  double time_s() const { return touch_.time_s(); }

  /// Takes up the step that the session is at, if it has not been: brings its molecule. False where there is none.
  bool enterStep();
  /// Does the current task as its kind shows how. True where the step has one and it was done.
  bool doTask();
  /// Gives the right answer to a question of the step: all right choices, the number, the first of the words; to a free
  /// question a sentence.
  void answerRightly(std::size_t question);
  /// Answers with choices by their index, or with text.
  void choose(std::size_t question, const std::vector<std::size_t>& choices);
  void write(std::size_t question, const std::string& text);
  void next();
  void back();
  /// False where there is no such step, or another must be finished first.
  bool goTo(const std::string& step);

  /// Every task, question and step, from where the session is to the end. True when the lesson was finished.
  bool demonstrate();
  /// The tasks and questions of every step not yet seen, whatever leads there: asides, extra steps, and what right
  /// answers skip.
  void demonstrateStepsLeft();

  /// Follows a plan; stops early where the task was done. The step must have been entered.
  void follow(const HandPlan& plan);
  /// The input from which plans are made now.
  HandPlanInput view(int attempt = 0) const { return touch_.view(attempt); }
  /// Tells the current task something.
  void tell(const TaskAnswer& answer);

 private:
  void demonstrateStep();
  void tick(const PoseA& hand);
  bool timeIsUp() const;
  void tellDone(std::size_t task);
  void tellAnswer(std::size_t question, const std::string& answer, bool right, int attempts_before);
  LearnerEvent event(LearnerEvent::Kind kind) const;

  LessonSession session_;
  MoleculeByName by_name_;
  Watch watch_;
  Options options_;
  VirtualTouch touch_;
  std::size_t entered_ = ~std::size_t{0};  // the scene number of the step that was entered
  bool on_stage_ = false;
  double task_begun_s_ = 0.0;
};

}  // namespace moltact
