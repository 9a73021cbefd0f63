// Keeps what a student does in a lesson: steps, answers, hints, tasks, touches and the way of the hand, as it happens.
// It only watches; a failure to write is reported once in a message and the lesson goes on. Window's thread.
//
// A lesson that is opened begins a new attempt; resume() goes on with an old one:
//   app.extensions().recorder.resume(lesson_file, progress.file);      // progress: engine/results/progress.h
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "app/ui/lesson/input_way_watch.h"
#include "app/ui/widgets/messages.h"
#include "engine/render/camera.h"
#include "engine/results/attempt_log.h"
#include "engine/results/session_watch.h"
#include "engine/results/touch_watch.h"

namespace moltact {

struct ApplicationOptions;
class LessonGuide;
class MovingStates;
class Opener;
struct PanelState;

class AttemptRecorder : public Extension {
 public:
  AttemptRecorder(const MovingStates& moving_states, Opener& opener, HapticSession& scene, LessonGuide& lesson,
                  Messages& messages, const PanelState& panels, const ApplicationOptions& options,
                  const FrameTime& time)
      : opener_(opener),
        scene_(scene),
        lesson_(lesson),
        messages_(messages),
        panels_(panels),
        options_(options),
        time_(time),
        moving_states_(moving_states) {}

  void beforeTicks() override;
  void ticks(const FeltTicks& felt) override;
  void afterPanels() override;
  void sceneChanged() override;
  void lessonChanged() override;
  void atEnd() override;

  /// Opens the lesson where the attempt was left, with what was done; what comes goes into the same file. An attempt
  /// that cannot be read is reported, and the lesson starts from its beginning.
  void resume(const std::filesystem::path& lesson_file, const std::filesystem::path& attempt_file);

  /// From here on another student (a name or code; empty: none is kept) works: the lesson starts from its beginning for
  /// him, in an attempt of his own, at the step that is shown; what he has done under this name since the program began
  /// is taken up.
  void passTo(const std::string& student);
  const std::string& student() const { return student_; }
  /// Ends the attempt that goes on; of what is opened from here on no name is kept.
  void forgetStudent() {
    endAttempt();
    student_.clear();
  }
  /// Ends the attempt that goes on.
  void finish() { endAttempt(); }

  /// A guess of someone who waits, kept with the attempt that goes on.
  void keepPrediction(Predicted prediction);

  /// The file of the attempt; empty before it is there, and where nothing is kept.
  std::filesystem::path file() const { return log_ ? log_->file() : std::filesystem::path(); }
  /// Waits until all is written.
  bool flush() { return !log_ || log_->flush(); }
  /// While something is played back nothing is kept.
  void pause(bool on);

 private:
  Opener& opener_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  Messages& messages_;
  const PanelState& panels_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  const MovingStates& moving_states_;
  struct Turn {
    std::string student;
    std::filesystem::path lesson, file;
  };
  void beginNew();
  void beginParts();
  void add(AttemptFact fact) { add(AttemptEvent{now_s_, std::move(fact)}); }
  void add(AttemptEvent event);
  void lookAtStage();
  void lookAtStates();
  void lookAtView();
  void lookAtWay();
  void endAttempt();
  void tell();

  std::string student_;
  std::vector<Predicted> predictions_;  // made while there was no attempt
  std::vector<Turn> turns_;  // attempts of this run, by student, so that a turn goes on where the last one ended
  std::optional<AttemptLog> log_;
  MessageId unkept_ = 0;               // the message that it is not kept on the disk, as long as that holds
  const void* session_ = nullptr;      // whose attempt it is
  std::filesystem::path lesson_file_;  // its file
  std::string hash_;
  SessionWatch session_watch_;
  TouchWatch touch_watch_;
  InputWayWatch input_;
  double now_s_ = 0.0;  // of use since log_ began
  double view_told_s_ = -1.0, states_told_s_ = -1.0;
  std::optional<InputChanged> way_;
  std::optional<StageChanged> stage_;
  std::optional<StatesMoved> states_;
  std::optional<Camera> view_;
  std::size_t hints_ = 0;  // open in the last frame
  bool paused_ = false, mending_begun_ = false;
  std::future<std::size_t> mended_;
};

}  // namespace moltact
