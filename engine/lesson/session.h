// A student's way through a lesson: the step, the tasks done, the questions answered. Used on the screen's thread.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/lesson/tasks/task.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// How a task stands.
struct TaskStatus {
  bool done = false;
  bool current = false;    ///< the one that the student is at now; at most one in a step
  double progress = 0.0;   ///< 0 to 1
  std::string say;         ///< what the lesson asks for
  std::string sentence;    ///< what to do next, or the praise; empty for tasks whose turn has not come
};

/// How a question stands.
struct QuestionStatus {
  bool answered_right = false;     ///< stays once it is so; a free answer counts as right
  int attempts = 0;
  std::vector<std::size_t> chosen; ///< the choices of the last attempt, ascending
  std::string written;             ///< the text of the last attempt
  bool last_right = false;         ///< of the last attempt
};

class LessonSession {
 public:
  /// Starts at the first step. `lesson` must not be null and has at least one step.
  explicit LessonSession(std::shared_ptr<const Lesson> lesson);

  const Lesson& lesson() const { return *lesson_; }
  std::size_t stepIndex() const { return step_; }
  const Step& step() const { return lesson_->steps[step_]; }

  /// What is on the stage now. `sceneNumber` grows whenever it may have changed, so the screen can compare it cheaply.
  const SceneSpec& scene() const { return step().scene; }
  std::size_t sceneNumber() const { return scene_number_; }

  bool hasNext() const { return step_ + 1 < lesson_->steps.size(); }
  bool hasBack() const { return step_ > 0; }
  /// Moves on or back; does nothing at the ends. A student may always move on: `stepDone` tells whether anything is left.
  void next();
  void back();
  /// Follows a link "#step-id" (or the id alone). False, without moving, where there is no such step.
  bool goTo(std::string_view link);

  /// The molecule on the stage, once it has been read: the tasks of the step need it to know their atoms. Null while there
  /// is none; tasks then wait. Keeps what has been done.
  void setMolecule(std::shared_ptr<const Molecule> molecule);

  /// Feeds the current task of the step. Tasks are done in their order, one at a time.
  void feed(const TouchSample& sample);
  void feed(std::span<const TouchSample> samples);

  /// The tasks and questions of the current step, by their index in it.
  TaskStatus task(std::size_t index) const;
  const QuestionStatus& question(std::size_t index) const { return state().questions[index]; }

  /// Begins a task of the current step again, done or not.
  void restartTask(std::size_t index);

  /// Answers a question of the current step with choices. Gives whether it is right: exactly the right ones. An index
  /// out of range makes the answer wrong.
  bool choose(std::size_t question, std::vector<std::size_t> choices);
  /// Answers a question that has an answer block. Numbers may have their unit or leave it out; words are compared without
  /// capitals and outer spaces. An empty text is no attempt and gives false.
  bool write(std::size_t question, std::string text);
  /// What is said to the last attempt at a question: the feedback of each chosen choice, or of the answer block.
  std::vector<RichText> feedback(std::size_t question) const;

  /// Every task of the step is done and every question answered rightly.
  bool stepDone() const { return stepDone(step_); }
  bool stepDone(std::size_t step) const;
  /// Tasks and questions done, of all in the lesson, 0 to 1; the share of steps seen where it has none.
  double progress() const;
  bool finished() const;

  /// Takes a lesson that was read again: the student stays on the step of the same id (else of the same number), and keeps
  /// what was done in steps whose tasks and questions are the same in number and kind.
  void replaceLesson(std::shared_ptr<const Lesson> lesson);

 private:
  struct StepState {
    std::vector<char> tasks_done;
    std::vector<QuestionStatus> questions;
    bool seen = false;
  };

  StepState& state() { return states_[step_]; }
  const StepState& state() const { return states_[step_]; }
  std::size_t currentTask() const;
  void enter(std::size_t step);
  void makeTasks();
  void record(std::size_t question, bool right);

  std::shared_ptr<const Lesson> lesson_;
  std::shared_ptr<const Molecule> molecule_;
  std::vector<StepState> states_;
  std::vector<std::unique_ptr<Task>> tasks_;  // of the current step; null while there is no molecule
  std::size_t step_ = 0, scene_number_ = 0;
};

}  // namespace moltact
