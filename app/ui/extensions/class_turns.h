// One device for a class, in the window: whose turn it is, handing over, and what those who wait predict meanwhile.
// While the device changes hands no force is given and nothing is felt. Window's thread.
#pragma once

#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "app/ui/lesson/lesson_guide.h"
#include "engine/results/turns.h"

namespace moltact {

class AttemptRecorder;
struct PanelState;

class ClassTurns : public Extension {
 public:
  ClassTurns(AttemptRecorder& recorder, HapticSession& scene, const LessonGuide& lesson, PanelState& panels,
             const FrameTime& time)
      : scene_(scene), lesson_(lesson), panels_(panels), time_(time), recorder_(recorder) {}

  const Turns& turns() const { return turns_; }
  bool on() const { return turns_.on(); }

  /// Calls the first of the names.
  void begin(std::vector<std::string> names, double turn_s);
  /// The student who was called has the device: his attempt goes on, or begins.
  void start();
  void passOn();
  /// The one who was called is not here.
  void skip();
  void pause() { turns_.pause(); }
  void goOn() { turns_.goOn(); }
  void extend(double by_s) { turns_.extend(by_s); }
  void end();

  /// The question for those who wait: about the task or the question that the class is at.
  std::string prompt(const LessonGuide& lesson) const;
  /// Keeps what one of them predicts. False, keeping nothing, for an empty text or a name that does not wait.
  bool predict(const std::string& name, const std::string& text);
  std::size_t predictionsKept() const { return predictions_; }

  /// The texts of the page and of the strip while a person fills them in.
  struct Draft {
    std::string names, prediction;
    double minutes = 3.0;
    std::size_t who = 0;  ///< of those who wait
  } draft;

  void beforeTicks() override;
  bool live() const override { return turns_.state() == Turns::State::Running; }

 private:
  HapticSession& scene_;
  const LessonGuide& lesson_;
  PanelState& panels_;
  const FrameTime& time_;
  AttemptRecorder& recorder_;
  void call();

  Turns turns_;
  std::size_t predictions_ = 0;
};

}  // namespace moltact
