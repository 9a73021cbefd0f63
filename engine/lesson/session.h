// A student's way through a lesson: the step, the tasks done, the questions answered. Used on the screen's thread.
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

/// How a task stands.
struct TaskStatus {
  bool done = false;  ///< solved, or its tries are used up
  bool solved = false;
  bool current = false;   ///< the one that the student is at now; at most one in a step
  double progress = 0.0;  ///< 0 to 1
  std::string say;        ///< what the lesson asks for
  std::string sentence;   ///< what to do next, or the praise; empty for tasks whose turn has not come
};

/// How a question stands.
struct QuestionStatus {
  bool answered_right = false;  ///< stays once it is so; a free answer and a prediction count as right
  int attempts = 0;
  std::vector<std::size_t> chosen;  ///< the choices of the last attempt, ascending
  std::string written;              ///< the text of the last attempt
  bool last_right = false;          ///< of the last attempt
  std::string again;                ///< why what was written since is no attempt, and what would be one; else empty
  bool shown = false;               ///< the tries are used up: what is right stands there, and nothing is left to do
  bool gone = false;                ///< the student has left the step since the last answer

  bool done() const { return answered_right || shown; }
};

/// The work done in a lesson, by the ids of its steps and questions: a session is resumed from it.
struct SessionMemory {
  struct StepMemory {
    std::string step{};                                               ///< id
    std::vector<std::size_t> tasks_done{};                            ///< indices of tasks that were solved
    std::vector<std::size_t> tasks_shown{};                           ///< of those whose tries were used up
    std::vector<std::pair<std::string, QuestionStatus>> questions{};  ///< by the question's id
  };
  std::string step;               ///< id of the step to begin at
  std::vector<StepMemory> steps;  ///< in the order in which they were first entered
};

/// What is right, as one line; empty for a free answer.
std::string rightAnswer(const Question& asked);

class LessonSession {
 public:
  /// Starts at the first step. `lesson` must not be null and has at least one step.
  explicit LessonSession(std::shared_ptr<const Lesson> lesson);

  const Lesson& lesson() const { return *lesson_; }
  std::size_t stepIndex() const { return step_; }
  const Step& step() const { return lesson_->steps[step_]; }
  /// The same, but in an aside the step that it belongs to: the last one that is no aside.
  std::size_t mainStepIndex() const { return main_step_; }

  /// The steps that count, in order: asides do not, nor what is skipped; mainStepIndex() is always among them.
  std::vector<std::size_t> way() const;
  /// The number, from 1, that students read for a step of way().
  std::size_t numberOf(std::size_t step) const;

  /// The scene on the stage now. `sceneNumber` grows whenever it may have changed, so the screen can compare it
  /// cheaply.
  const SceneSpec& scene() const { return step().scene; }
  std::size_t sceneNumber() const { return scene_number_; }

  bool hasNext() const;
  bool hasBack() const { return step().aside || step_ > 0; }
  /// Moves on or back, passing over asides and what is skipped; does nothing at the ends. From an aside both lead to
  /// the step from which the student came to it. Next goes where an answer leads (leadsTo), and does not leave a step
  /// that must be finished first.
  void next();
  void back();
  /// Goes to "#step-id" (or the id alone), whatever must be finished first: `mayGoTo` says that. False, without moving,
  /// where there is no such step.
  bool goTo(std::string_view link);

  /// Whether Next leads on: the step need not be finished, or is, or an answer leads away from it.
  bool mayGoOn() const;
  /// Whether a link leads there: no step before it, from where the student is, must be finished first. True where there
  /// is no such step.
  bool mayGoTo(std::string_view link) const;
  /// The step to which an answer in this one leads: back or into an aside once, until the student has gone; forward
  /// from then on.
  std::optional<std::size_t> leadsTo() const;
  /// The same for one question of the step.
  std::optional<std::size_t> leadsTo(std::size_t question) const;
  /// Whether an answer lets Next pass a step over. It does not count for the progress then.
  bool skipped(std::size_t step) const { return skippedSteps()[step] != 0; }
  /// Whether a rule of a question of any step has come true.
  bool ruleHolds(std::size_t step, std::size_t question, std::size_t rule) const;

  /// What happened since the events were last taken, oldest first.
  const std::vector<SessionEvent>& events() const { return events_; }
  std::vector<SessionEvent> takeEvents();
  /// Drops the events and reports the present step and task again, for an observer that begins here.
  void restartEvents();

  /// The number of hints of the step that are open, the first ones.
  std::size_t hintsOpen() const { return hints_; }
  void openHints(std::size_t count);

  /// The molecule on the stage, once it has been read: the tasks of the step need it to know their atoms. Null while
  /// there is none; tasks then wait. Keeps what has been done.
  void setMolecule(std::shared_ptr<const Molecule> molecule);

  /// Null while there is none.
  const Molecule* molecule() const { return molecule_.get(); }

  /// Feeds the current task of the step. Tasks are done in their order, one at a time.
  void feed(const TouchSample& sample);
  void feed(std::span<const TouchSample> samples);

  /// The tasks and questions of the current step, by their index in it.
  TaskStatus task(std::size_t index) const;
  const QuestionStatus& question(std::size_t index) const { return state().questions[index]; }

  /// A task of the current step, for its buttons, curves and figures; null while there is no molecule and it is not
  /// done.
  const Task* taskAt(std::size_t index) const;
  /// The index of the task that the student is at; the number of tasks when all are done.
  std::size_t currentTask() const;
  /// The changes of the scene that the current task asks for; none where there is no task.
  TaskStage taskStage() const;
  /// Tells the current task something.
  void answerTask(const TaskAnswer& answer);
  /// The figures that a task of the current step has measured so far, or until it was done; empty while there is no
  /// molecule.
  std::vector<TaskFigure> taskFigures(std::size_t index) const;

  /// Begins a task of the current step again, done or not.
  void restartTask(std::size_t index);

  /// The order in which the choices of a question of the current step stand: as they are written, or another for each
  /// seed but 0, the same for the same one.
  std::vector<std::size_t> choiceOrder(std::size_t question) const;
  /// Also what tasks draw by (Task::drawBy): that is another in each sitting, for which 0, 1, 2 … are counted where an
  /// attempt is taken up again, and whenever a step is entered anew. To be called before a task is begun.
  void setOrderSeed(std::uint64_t seed, std::size_t sitting = 0);

  /// Whether a question of the current step takes an answer: until one was right or the tries are used up, a prediction
  /// until it is told; not while an answer leads the student elsewhere first.
  bool takesAnswer(std::size_t question) const;
  /// Whether it may be said if the last attempt was right: there is one, and for a prediction all tasks of the step are
  /// done.
  bool told(std::size_t question) const;

  /// Answers a question of the current step with choices. Gives whether it is right: exactly the right ones. An index
  /// out of range makes the answer wrong. False, without an attempt, where it takes none.
  bool choose(std::size_t question, std::vector<std::size_t> choices);
  /// Answers a question that has an answer block. Numbers may have their unit or leave it out; words are compared
  /// without capitals and outer spaces. A text that is empty, or no number where one is asked for, is no attempt and
  /// gives false; QuestionStatus::again says why.
  bool write(std::size_t question, std::string text);
  /// How many tries a question of the current step leaves; no value where there is no limit.
  std::optional<int> triesLeft(std::size_t question) const;
  /// The feedback to the last attempt at a question: the feedback of each chosen choice, or of the answer block, and
  /// where the tries are used up what is right; to a free answer the author's own. Empty where nothing is told yet.
  std::vector<RichText> feedback(std::size_t question) const;

  /// The same of any step, whether it is shown or not.
  bool taskDone(std::size_t step, std::size_t task) const { return states_[step].tasks_done[task] != kOpen; }
  bool taskSolved(std::size_t step, std::size_t task) const { return states_[step].tasks_done[task] == kSolved; }
  /// Atoms that show the answer to tasks of the current step whose tries were used up in this sitting, and examples of
  /// what the current task asks for once it has been tried for long; ascending.
  std::vector<std::uint32_t> shownAtoms() const;
  const QuestionStatus& question(std::size_t step, std::size_t index) const { return states_[step].questions[index]; }
  /// Figures of a task that was done, of any step; empty where it was done before the session was taken up.
  std::vector<TaskFigure> figuresOf(std::size_t step, std::size_t task) const;
  bool stepSeen(std::size_t step) const { return states_[step].seen; }
  /// The steps that were entered, asides too, each once, in the order in which the student first met them.
  const std::vector<std::size_t>& met() const { return met_; }

  /// Takes up what was done before, as far as the lesson still has it, and goes to the step where that ended. Ids and
  /// indices that the lesson does not have are passed over.
  void restore(const SessionMemory& memory);

  /// Every task of the step is done and every question answered rightly, or the tries are used up.
  bool stepDone() const { return stepDone(step_); }
  bool stepDone(std::size_t step) const;
  /// Tasks and questions done, of all on the way; steps seen where there are none. Neither asides count nor what is
  /// skipped.
  struct Parts {
    std::size_t done = 0, of = 0;
  };
  Parts parts() const;
  /// The same, 0 to 1.
  double progress() const;
  bool finished() const;

  /// Takes a lesson that was read again: the student stays on the step of the same id (else of the same number), and
  /// keeps what was done in steps whose tasks and questions are the same in number and kind.
  void replaceLesson(std::shared_ptr<const Lesson> lesson);

 private:
  static constexpr char kOpen = 0, kSolved = 1, kShown = 2;  // how a task stands
  struct StepState {
    explicit StepState(const Step& step);
    std::vector<char> tasks_done;
    std::vector<std::shared_ptr<const Task>> finished;  // as they were when done; null where not done
    std::vector<QuestionStatus> questions;
    bool seen = false;
    std::uint32_t made = 0;  // how often its tasks were made
  };

  StepState& state() { return states_[step_]; }
  const StepState& state() const { return states_[step_]; }
  std::size_t mainStepAfter(std::size_t step) const;  // the number of steps where there is none
  std::vector<char> skippedSteps() const;
  bool waits(std::size_t step) const;  // it must be finished first, and no answer leads away from it
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
  std::vector<std::shared_ptr<Task>> tasks_;  // of the current step; null while there is no molecule
  Slide slide_;                               // that the hand is at, whichever task it belongs to,
  std::vector<TouchSample> slid_;             // and its samples, thinned
  std::vector<std::size_t> met_;
  std::size_t step_ = 0, scene_number_ = 0;
  std::size_t main_step_ = 0;  // the last one that is no aside
  std::uint64_t order_seed_ = 0;
  std::size_t sitting_ = 0;
  std::vector<SessionEvent> events_;
  std::optional<std::size_t> reported_task_;  // the last one in an event of this step
  std::size_t hints_ = 0;
};

}  // namespace moltact
