// A student at the window who knows where to go: carries out what each kind of task shows (Task::demonstrate) with the
// mouse alone or with the keyboard alone, through the application's input queue. What it cannot do, no hand can.
#pragma once

#include <string>

#include "app/ui/shell/scripted_user.h"
#include "engine/lesson/session.h"

namespace moltact {

class LessonHand {
 public:
  enum class By { Mouse, Keyboard };
  LessonHand(ScriptedUser& driver, By by) : d_(driver), by_(by) {}

  /// Does every task and answers every question of the lesson that is open. True when it was finished.
  bool finishLesson();
  /// What it could not do, one a line.
  const std::string& failed() const { return failed_; }

 private:
  bool mouse() const { return by_ == By::Mouse; }
  LessonSession& session() const;
  bool doTask(std::size_t task);
  void follow(const HandPlan& plan, std::size_t task);
  bool goesOn(std::size_t task) const;

  void answerRightly(std::size_t question);
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
  void lift();
  /// Pushes harder or lighter until the spring would give so much.
  void push(double force_N);
  /// Leads the hand sideways, pressing or not, until it appears where the place does.
  void lead(const Vec3& place_A, std::size_t task);
  void holdArrows(glm::ivec2 way);
  double N_per_A() const;

  ScriptedUser& d_;
  By by_;
  bool pressing_ = false;
  double pushed_N_ = 0.0;
  glm::ivec2 arrows_{0};
  std::string failed_;
};

}  // namespace moltact
