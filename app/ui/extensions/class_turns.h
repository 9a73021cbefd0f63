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

class ClassTurns : public Extension {
 public:
  explicit ClassTurns(AttemptRecorder& recorder) : recorder_(recorder) {}

  const Turns& turns() const { return turns_; }
  bool on() const { return turns_.on(); }

  /// Calls the first of the names.
  void begin(Application& app, std::vector<std::string> names, double turn_s);
  /// The student who was called has the device: his attempt goes on, or begins.
  void start(Application& app);
  void passOn();
  /// The one who was called is not here.
  void skip(Application& app);
  void pause() { turns_.pause(); }
  void goOn() { turns_.goOn(); }
  void extend(double by_s) { turns_.extend(by_s); }
  void end(Application& app);

  /// The question for those who wait: about the task or the question that the class is at.
  std::string prompt(const LessonGuide& lesson) const;
  /// Keeps what one of them predicts. False, keeping nothing, for an empty text or a name that does not wait.
  bool predict(Application& app, const std::string& name, const std::string& text);
  std::size_t predictionsKept() const { return predictions_; }

  /// The texts of the page and of the strip while a person fills them in.
  struct Draft {
    std::string names, prediction;
    double minutes = 3.0;
    std::size_t who = 0;  ///< of those who wait
  } draft;

  void beforeTicks(Application& app) override;
  bool live() const override { return turns_.state() == Turns::State::Running; }

 private:
  AttemptRecorder& recorder_;
  void call();

  Turns turns_;
  std::size_t predictions_ = 0;
};

}  // namespace moltact
