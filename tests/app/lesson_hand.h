// A student at the window who knows the answers. Executes the demonstration of each task (Task::demonstrate) with the
// mouse only or the keyboard only, through the application's input queue. What it cannot do, no user can. An erring
// student first gives every wrong choice and a wrong number, and makes the mistakes that a task permits.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/ui/shell/scripted_user.h"
#include "engine/lesson/session.h"

namespace moltact {

class LessonHand {
 public:
  enum class By { Mouse, Keyboard };
  enum class First { Right, Wrong };
  LessonHand(ScriptedUser& driver, By by, First first = First::Right)
      : d_(driver), by_(by), errs_(first == First::Wrong) {}

  /// Does every task and answers every question of the open lesson. Returns true if the lesson was finished. Returns
  /// false, with the window's messages in failed(), if no lesson is open.
  bool finishLesson();
  /// What it could not do, one item per line.
  const std::string& failed() const { return failed_; }
  /// Executes a plan while the task is active.
  void follow(const HandPlan& plan, std::size_t task);
  /// The input of a plan: the present scene as the hand meets it.
  HandPlanInput planInput(int attempt) const;
  /// A plan with a mistake for this kind of task; empty if the kind permits none.
  HandPlan wrongPlan(std::size_t task) const;
  /// Releases the surface.
  void lift();
  /// Called after each frame in which the hand rests at a place or slides over the surface.
  std::function<void()> watch;
  /// The number of wrong answers and acts that were rejected and solved nothing.
  int wrongAnswers() const { return wrong_answers_; }

 private:
  bool mouse() const { return by_ == By::Mouse; }
  /// Whether a lesson is open and a molecule is loaded; otherwise failed() contains the window's message.
  bool canBegin();
  LessonSession& session() const;
  bool doTask(std::size_t task);
  bool isCurrent(std::size_t task) const;

  void answerCorrectly(std::size_t question);
  void answerWrongly(std::size_t question);
  /// Makes the mistakes possible in this kind of task: a guess elsewhere, the first pair inverted, a probe that is too
  /// small, the other end marked first. Does nothing for other kinds.
  void doWrongly(std::size_t task);
  double figure(std::size_t task, std::string_view name) const;
  void pick(std::size_t question, std::size_t choice);
  void handIn(std::size_t question);
  void writeIn(std::size_t question, const std::string& text);
  void expect(bool held, const std::string& what);
  void tell(std::size_t task, const TaskAnswer& answer);
  /// Sets a task's slider to the step nearest to this value.
  void slideTo(std::size_t task, double value);
  void draw(const std::string& name, const std::vector<double>& curve, double max_N);
  void useMethod(const std::string& name);

  /// Moves the atoms to this share of the way between the scene's structures and waits until they are there: with the
  /// mouse by the slider, with the keyboard by the button of that end.
  void moveStates(double share);
  /// Moves them to both ends and back, and keeps both structures for planInput().
  void lookAtStates();
  Quat bodyTurned() const;
  /// Turns what the hand holds by drags with Ctrl, or by the arrow keys with Ctrl and Shift.
  void turnBodyTo(const Quat& wanted);
  /// A straight approach of the body to a pose, and where it stops.
  struct Approach {
    Vec3 toViewer{0.0, 0.0, 1.0}, aim{0.0}, stop{0.0};
    Quat turned = kNoRotation;
    double off_A = 1e300;  ///< root mean square distance of the atoms from their places in the pose
    bool meets() const { return off_A < 1e300; }
  };
  /// The best of many drawn approaches, from any side or from this eye, in any near orientation or in this one.
  Approach approachTo(const PoseA& end, std::uint64_t seed, const std::optional<Vec3>& from,
                      const std::optional<Quat>& turned) const;
  /// Brings the body to the end of a plan. Returns false without a body.
  bool followWithBody(const HandPlan& plan, std::size_t task);

  /// The position of a place on the screen, as shares of the view's width and height.
  glm::dvec2 seen(const Vec3& place_A) const;
  Vec3 outward(const Vec3& place_A) const;
  /// A direction from which the plan's places from the k-th on are visible, as many consecutive ones as possible.
  Vec3 openFrom(const HandPlan& plan, std::size_t k) const;
  /// Rotates the molecule until this direction faces the student.
  void face(Vec3 direction);
  void pointAt(const Vec3& place_A);
  void press();
  /// Changes the push until the spring gives this force.
  void push(double force_N);
  /// Moves the hand sideways, pressing or not, to the place's position on the screen.
  void lead(const Vec3& place_A, std::size_t task);
  void holdArrows(glm::ivec2 way);
  double N_per_A() const;

  ScriptedUser& d_;
  By by_;
  bool errs_ = false;
  int wrong_answers_ = 0;
  bool pressing_ = false;
  double pushed_N_ = 0.0;
  glm::ivec2 arrows_{0};
  std::vector<std::pair<double, std::shared_ptr<const SphereGrid>>> structures_;  // of the task's scene, by share
  std::uint64_t approaches_ = 0;  // of a body, so far: each draws others
  std::string failed_;
};

}  // namespace moltact
