// The state of a student in a lesson: the step, the tasks done, the questions answered. Window's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/lesson/session_events.h"
#include "engine/lesson/tasks/task.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// The state of a task.
struct TaskStatus {
  bool done = false;  ///< solved, or its tries are used up
  bool solved = false;
  bool current = false;   ///< the student's current one; at most one in a step
  double progress = 0.0;  ///< 0 to 1
  std::string say;        ///< the instruction
  std::string sentence;   ///< what to do next, or the praise; empty for later tasks
};

/// The state of a question.
struct QuestionStatus {
  bool answered_right = false;  ///< once true it stays true; a free answer and a prediction count as right
  int attempts = 0;
  std::vector<std::size_t> chosen;  ///< the choices of the last attempt, ascending
  std::string written;              ///< the text of the last attempt
  bool last_right = false;          ///< of the last attempt
  /// The reason why the last text was not accepted as an answer, and what is accepted; empty if it was accepted.
  std::string again;
  bool shown = false;              ///< the tries are used up: the right answer is shown, and nothing is left to do
  bool left_since_answer = false;  ///< the student has left the step since the last answer

  bool done() const { return answered_right || shown; }
};

/// The work done in a lesson, by the ids of its steps and questions; a session is resumed from it.
struct SessionMemory {
  struct StepMemory {
    std::string step{};                                               ///< id
    std::vector<std::size_t> tasks_done{};                            ///< indices of tasks that were solved
    std::vector<std::size_t> tasks_shown{};                           ///< of tasks whose tries were used up
    std::vector<std::pair<std::string, QuestionStatus>> questions{};  ///< by the question's id
  };
  std::string step;               ///< id of the step to begin at
  std::vector<StepMemory> steps;  ///< in the order in which they were first entered
};

/// The right answer as one line; empty for a free answer.
std::string rightAnswer(const Question& asked);

/// Indices of steps, tasks, questions and rules must be in range; this is not checked.
class LessonSession {
 public:
  /// Starts at the first step. `lesson` must not be null and has at least one step.
  explicit LessonSession(std::shared_ptr<const Lesson> lesson);

  const Lesson& lesson() const { return *lesson_; }
  std::size_t stepIndex() const { return step_; }
  const Step& step() const { return lesson_->steps[step_]; }
  /// The same; in an aside, the step to which it belongs: the last one before it that is not an aside.
  std::size_t mainStepIndex() const { return main_step_; }

  /// The steps on the student's route, in order: without asides and skipped steps, but always with mainStepIndex().
  std::vector<std::size_t> route() const;
  /// The number that is displayed for a step of route(), from 1.
  std::size_t numberOf(std::size_t step) const;

  /// The present scene. `sceneNumber` is incremented whenever it may have changed, so that a comparison is cheap.
  const SceneSpec& scene() const { return step().scene; }
  std::size_t sceneNumber() const { return scene_number_; }

  bool hasNext() const;
  bool hasBack() const { return step().aside || step_ > 0; }
  /// Moves to the next or previous step of the route; does nothing at its ends. From an aside, both return to the step
  /// from which the student came. next() goes where an answer leads (leadsTo). It does nothing while the step must be
  /// finished first.
  void next();
  void back();
  /// Enters the step "#step-id" (or "step-id"), even if another must be finished first; see mayGoTo. Returns false and
  /// stays if there is no such step.
  bool goTo(std::string_view link);

  /// Whether next() moves: the step need not be finished, is finished, or an answer leads elsewhere.
  bool mayGoOn() const;
  /// Whether only the teacher of a live class can let the student go on from the present step (class_hold.h).
  bool heldByClass() const;
  /// Whether a link may be followed: no step between the present one and its target must be finished first. True if
  /// there is no such step.
  bool mayGoTo(std::string_view link) const;
  /// The step to which an answer in this one leads. A rule that leads back or into an aside applies once, until the
  /// student has left the step; one that leads forward stays in force.
  std::optional<std::size_t> leadsTo() const;
  /// The same for one question of the step.
  std::optional<std::size_t> leadsTo(std::size_t question) const;
  /// Whether an answer makes next() skip a step. Skipped steps do not count for the progress.
  bool skipped(std::size_t step) const { return skippedSteps()[step] != 0; }
  /// Whether a rule of a question in any step applies.
  bool ruleHolds(std::size_t step, std::size_t question, std::size_t rule) const;

  /// What happened since the events were last taken, oldest first.
  const std::vector<SessionEvent>& events() const { return events_; }
  std::vector<SessionEvent> takeEvents();
  /// Drops the events and reports the present step and task again, for an observer that begins here.
  void restartEvents();

  /// The number of open hints of the step; hints open in order, from the first.
  std::size_t hintsOpen() const { return hints_; }
  void openHints(std::size_t count);

  /// Sets the step's molecule once it has been read; the tasks need its atoms. Null: none yet, and the tasks wait.
  /// Keeps the work done.
  void setMolecule(std::shared_ptr<const Molecule> molecule);

  /// Null if there is none.
  const Molecule* molecule() const { return molecule_.get(); }

  /// Passes a sample to the current task of the step. Tasks are done in order, one at a time.
  void feed(const TouchSample& sample);
  void feed(std::span<const TouchSample> samples);

  /// The tasks and questions of the current step, by their index in it.
  TaskStatus task(std::size_t index) const;
  const QuestionStatus& question(std::size_t index) const { return state().questions[index]; }

  /// A task of the current step, for its buttons, curves and figures; null if it is not done and there is no molecule.
  const Task* taskAt(std::size_t index) const;
  /// The index of the current task; the number of tasks if all are done.
  std::size_t currentTask() const;
  /// The changes of the scene that the current task requests; none without a task.
  TaskStage taskStage() const;
  /// The guide of the current task's present try; none without a task.
  std::optional<TaskGuide> taskGuide() const;
  /// Gives an answer to the current task.
  void answerTask(const TaskAnswer& answer);
  /// The quantities that a task of the current step has measured so far, or until it was done; empty without a
  /// molecule.
  std::vector<TaskFigure> taskFigures(std::size_t index) const;

  /// Restarts a task of the current step, done or not.
  void restartTask(std::size_t index);

  /// The order of the choices of a question in the current step: the author's for seed 0, otherwise a permutation that
  /// depends only on the seed.
  std::vector<std::size_t> choiceOrder(std::size_t question) const;
  /// Sets the seed of the choices' order and of the tasks' random draws (Task::drawBy). The draws also depend on
  /// `sitting` (0, 1, 2 … each time an attempt is resumed) and on how often the step was entered. Call it before a task
  /// begins.
  void setOrderSeed(std::uint64_t seed, std::size_t sitting = 0);

  /// Whether a question of the current step accepts an answer. True until an answer was right or the tries are used up;
  /// for a prediction, until its result is revealed; in a test always. False while an earlier answer sends the student
  /// to another step first.
  bool takesAnswer(std::size_t question) const;
  /// Whether the result of the last attempt may be shown: there is an attempt and, for a prediction, all tasks of the
  /// step are done. Never in a test.
  bool feedbackVisible(std::size_t question) const;

  /// Answers a question of the current step with choices. Returns true if they are exactly the right ones. An index out
  /// of range makes the answer wrong. If the question accepts none, returns false without counting an attempt.
  bool choose(std::size_t question, std::vector<std::size_t> choices);
  /// Answers a question with an answer block. Numbers may omit their unit; words are compared without regard to case
  /// and outer spaces. Empty text, or text that is not a number where one is required, is not an attempt: returns
  /// false, and QuestionStatus::again gives the reason.
  bool write(std::size_t question, std::string text);
  /// The remaining tries of a question in the current step; no value without a limit.
  std::optional<int> triesLeft(std::size_t question) const;
  /// The feedback on the last attempt at a question: that of each choice, or of the answer block. When the tries are
  /// used up, it includes the right answer; for a free answer, the author's model. Empty if nothing may be shown yet.
  std::vector<RichText> feedback(std::size_t question) const;

  /// The same for any step.
  bool taskDone(std::size_t step, std::size_t task) const { return states_[step].tasks_done[task] != kOpen; }
  bool taskSolved(std::size_t step, std::size_t task) const { return states_[step].tasks_done[task] == kSolved; }
  /// Atoms that show the answers of tasks in the current step whose tries were used up in this sitting. Includes
  /// examples for a current task that has been tried for long. Ascending.
  std::vector<std::uint32_t> shownAtoms() const;
  const QuestionStatus& question(std::size_t step, std::size_t index) const { return states_[step].questions[index]; }
  /// The quantities of a completed task of any step; empty if it was completed before the session was resumed.
  std::vector<TaskFigure> figuresOf(std::size_t step, std::size_t task) const;
  bool stepSeen(std::size_t step) const { return states_[step].seen; }
  /// The steps entered, including asides, each once, in the order of the first visit.
  const std::vector<std::size_t>& visitedSteps() const { return visited_steps_; }

  /// Restores earlier work as far as the lesson still contains it, and enters the step where it ended. Ignores unknown
  /// ids and indices.
  void restore(const SessionMemory& memory);

  /// Whether every task of the step is done and every question answered correctly, or their tries are used up.
  bool stepDone() const { return stepDone(step_); }
  bool stepDone(std::size_t step) const;
  /// Counts the tasks and questions on the route: those done, and all. A route without any counts its steps instead.
  /// Asides and skipped steps do not count.
  struct Parts {
    std::size_t done = 0, of = 0;
  };
  Parts parts() const;
  /// The same, 0 to 1.
  double progress() const;
  bool finished() const;

  /// Replaces the lesson after it was read again. The student stays at the step with the same id (otherwise the same
  /// number). Work is kept in steps whose tasks and questions agree in number and kind.
  void replaceLesson(std::shared_ptr<const Lesson> lesson);

 private:
  static constexpr char kOpen = 0, kSolved = 1, kShown = 2;  // the states of a task
  struct StepState {
    explicit StepState(const Step& step);
    std::vector<char> tasks_done;
    std::vector<std::shared_ptr<const Task>> finished;  // as they were when completed; null if not done
    std::vector<QuestionStatus> questions;
    bool seen = false;
    std::uint32_t made = 0;  // how often its tasks were constructed
  };

  StepState& state() { return states_[step_]; }
  const StepState& state() const { return states_[step_]; }
  std::size_t mainStepAfter(std::size_t step) const;  // the number of steps if there is none
  std::vector<char> skippedSteps() const;
  bool waits(std::size_t step) const;  // whether it must be finished first and no answer leads away from it
  bool classWaits(std::size_t step) const;
  void feedTask(std::size_t task, const TouchSample& sample);
  void keepIfDone(std::size_t task);
  void keepSlide(const TouchSample& sample);
  void enter(std::size_t step);
  void meet(std::size_t step);
  void makeTasks();
  std::uint64_t drawSeed(std::size_t task) const;
  void record(std::size_t question, bool right);

  // session_events.cpp
  struct CurveState {
    bool drawing = true, compared = false;
  };
  static CurveState curveState(const Task& task);
  void reportStep();
  void reportTask();
  void dropStartedTask();  // the event of a task that is over before anybody saw it begin
  void reportFinished(std::size_t task);
  void reportCurves(std::size_t task, CurveState before);
  void reportAnswer(std::size_t question, bool done_before, const std::vector<char>& rules_before);

  std::shared_ptr<const Lesson> lesson_;
  std::shared_ptr<const Molecule> molecule_;
  std::vector<StepState> states_;
  std::vector<std::shared_ptr<Task>> tasks_;  // of the current step; null without a molecule
  Slide slide_;                               // the current slide over the surface, independent of the task
  std::vector<TouchSample> slid_;             // its samples at a reduced rate, for the task that follows
  std::vector<std::size_t> visited_steps_;
  std::size_t step_ = 0, scene_number_ = 0;
  std::size_t main_step_ = 0;  // the last one that is not an aside
  std::uint64_t order_seed_ = 0;
  std::size_t sitting_ = 0;
  std::vector<SessionEvent> events_;
  std::optional<std::size_t> reported_task_;  // the last one in an event of this step
  std::size_t hints_ = 0;
};

}  // namespace moltact
