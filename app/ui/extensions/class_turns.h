// Turns of a class at one device: whose turn it is, the hand-over, and the predictions of those who wait. During a
// hand-over the device gives no force and nothing is felt. Window's thread.
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

  /// Starts with the first of the names. `turn_s`: the length of a turn.
  void begin(std::vector<std::string> names, double turn_s);
  /// The called student has the device; the student's attempt continues or begins.
  void start();
  void passOn();
  /// The called student is absent: calls the next one.
  void skip();
  void pause() { turns_.pause(); }
  void resume() { turns_.resume(); }
  void extend(double by_s) { turns_.extend(by_s); }
  void end();

  /// The question for those who wait, about the current task or question.
  std::string prompt(const LessonGuide& lesson) const;
  /// Stores a prediction. Returns false and stores nothing if the text is empty or the name is not among those who
  /// wait.
  bool predict(const std::string& name, const std::string& text);
  std::size_t predictionsKept() const { return predictions_; }

  /// The contents of the input fields on the page and the strip.
  struct Draft {
    std::string names, prediction;
    double minutes = 3.0;
    std::size_t who = 0;  ///< index among those who wait
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
