// A student at the window who knows where to go: carries out what each kind of task shows (Task::demonstrate) with the
// mouse alone or with the keyboard alone, through the application's input queue. What it cannot do, no hand can. One
// who errs gives every wrong choice and a wrong number first, and does wrongly what a task lets one do wrongly.
#pragma once

#include <functional>
#include <string>

#include "app/ui/shell/scripted_user.h"
#include "engine/lesson/session.h"

namespace moltact {

class LessonHand {
 public:
  enum class By { Mouse, Keyboard };
  enum class First { Right, Wrong };
  LessonHand(ScriptedUser& driver, By by, First first = First::Right)
      : d_(driver), by_(by), errs_(first == First::Wrong) {}

  /// Does every task and answers every question of the lesson that is open. True when it was finished; false, with the
  /// window's own words in failed(), where none is open.
  bool finishLesson();
  /// What it could not do, one a line.
  const std::string& failed() const { return failed_; }
  /// Does what a plan for the task says, as far as the task goes on.
  void follow(const HandPlan& plan, std::size_t task);
  /// What a plan is made for: the scene as the hand meets it now.
  HandPlanInput planInput(int attempt) const;
  /// What can be done wrongly in a task of this kind; empty where there is no such act.
  HandPlan wrongPlan(std::size_t task) const;
  /// Lets go of the surface.
  void lift();
  /// Called after each frame in which the hand rests at a place or is led over the surface.
  std::function<void()> watch;
  /// How many wrong answers and wrong acts were told to be so, and solved nothing.
  int toldWrong() const { return told_wrong_; }

 private:
  bool mouse() const { return by_ == By::Mouse; }
  /// Whether a lesson is open and a molecule on the stage; else what the window said instead is told in failed().
  bool canBegin();
  LessonSession& session() const;
  bool doTask(std::size_t task);
  bool goesOn(std::size_t task) const;

  void answerRightly(std::size_t question);
  void answerWrongly(std::size_t question);
  /// What can be wrong in a task of this kind: a guess elsewhere, a first pair taken for its contrary, a probe that is
  /// too small, the other end marked first. Nothing for kinds without such an act.
  void doWrongly(std::size_t task);
  double figure(std::size_t task, std::string_view name) const;
  void pick(std::size_t question, std::size_t choice);
  void handIn(std::size_t question);
  void writeIn(std::size_t question, const std::string& text);
  void expect(bool held, const std::string& what);
  void tell(std::size_t task, const TaskAnswer& answer);
  /// Sets the slider of a task to the step nearest to this value.
  void slideTo(std::size_t task, double value);
  void draw(const std::string& name, const std::vector<double>& curve, double most_N);
  void useMethod(const std::string& name);

  /// Where a place appears, as a share of the view's width and height.
  glm::dvec2 seen(const Vec3& place_A) const;
  Vec3 outward(const Vec3& place_A) const;
  /// The direction from which the plan's places are to be seen from the k-th on, as many in a row as can be.
  Vec3 openFrom(const HandPlan& plan, std::size_t k) const;
  /// Turns the molecule until this direction looks at the student.
  void face(Vec3 direction);
  void pointAt(const Vec3& place_A);
  void press();
  /// Pushes harder or lighter until the spring would give so much.
  void push(double force_N);
  /// Leads the hand sideways, pressing or not, until it appears where the place does.
  void lead(const Vec3& place_A, std::size_t task);
  void holdArrows(glm::ivec2 way);
  double N_per_A() const;

  ScriptedUser& d_;
  By by_;
  bool errs_ = false;
  int told_wrong_ = 0;
  bool pressing_ = false;
  double pushed_N_ = 0.0;
  glm::ivec2 arrows_{0};
  std::string failed_;
};

}  // namespace moltact
