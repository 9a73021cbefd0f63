// Records a student's work on a lesson as it happens: steps, answers, hints, tasks, touches and the hand's path. It
// only observes. A failure to write is reported once in a message, and the lesson continues. Window's thread.
//
// Opening a lesson begins a new attempt; resume() continues an earlier one:
//   app.extensions().recorder.resume(lesson_file, progress.file);      // progress: engine/results/progress.h
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "app/ui/lesson/input_kind_watch.h"
#include "app/ui/widgets/messages.h"
#include "engine/render/camera.h"
#include "engine/results/attempt_log.h"
#include "engine/results/session_facts.h"
#include "engine/results/touch_watch.h"

namespace moltact {

struct ApplicationOptions;
class LessonGuide;
class AtomMovers;
class Opener;
struct PanelState;

class AttemptRecorder : public Extension {
 public:
  AttemptRecorder(const AtomMovers& movers, Opener& opener, HapticSession& scene, LessonGuide& lesson,
                  Messages& messages, const PanelState& panels, const ApplicationOptions& options,
                  const FrameTime& time)
      : opener_(opener),
        scene_(scene),
        lesson_(lesson),
        messages_(messages),
        panels_(panels),
        options_(options),
        time_(time),
        movers_(movers) {}

  void beforeTicks() override;
  void ticks(const FeltTicks& felt) override;
  void lessonEvents(std::span<const SessionEvent> events) override;
  void afterPanels() override;
  void sceneChanged() override;
  void lessonChanged() override;
  void atEnd() override;

  /// Opens the lesson at the point where the attempt ended and restores its work; new events are appended to the same
  /// file. An attempt that cannot be read is reported, and the lesson starts from its beginning.
  void resume(const std::filesystem::path& lesson_file, const std::filesystem::path& attempt_file);

  /// Switches to another student (a name or code; empty: no name is recorded), who starts the lesson at the present
  /// step in an attempt of his own. If he has already worked under this name since the program started, that attempt is
  /// continued.
  void passTo(const std::string& student);
  const std::string& student() const { return student_; }
  /// Ends the current attempt. The next attempts have no student's name.
  void forgetStudent() {
    endAttempt();
    student_.clear();
  }
  /// Ends the current attempt.
  void finish() { endAttempt(); }

  /// Records a prediction of a waiting student in the current attempt.
  void keepPrediction(Predicted prediction);

  /// The attempt's file; empty before it exists and if nothing is recorded.
  std::filesystem::path file() const { return log_ ? log_->file() : std::filesystem::path(); }
  /// Waits until everything is written. Returns false after a failure to write.
  bool flush() { return !log_ || log_->flush(); }
  /// Stops recording, for example during playback, or continues it.
  void pause(bool on);

 private:
  Opener& opener_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  Messages& messages_;
  const PanelState& panels_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  const AtomMovers& movers_;
  struct Turn {
    std::string student;
    std::filesystem::path lesson, file;
  };
  void beginNew();
  void beginParts();
  void add(AttemptFact fact) { add(AttemptEvent{now_s_, std::move(fact)}); }
  void add(AttemptEvent event);
  void lookAtStage();
  void lookAtAtoms();
  void lookAtView();
  void lookAtWay();
  void endAttempt();
  void tell();

  std::string student_;
  std::vector<Predicted> predictions_;  // made before there was an attempt
  std::vector<Turn> turns_;  // attempts since the program started, by student, so that a turn continues the student's
                             // last one
  std::optional<AttemptLog> log_;
  MessageId unkept_ = 0;               // the message that the attempt is not stored on disk, while this is the case
  const void* session_ = nullptr;      // the session of the attempt
  std::filesystem::path lesson_file_;  // its file
  std::string hash_;
  SessionFacts session_facts_;
  std::vector<SessionEvent> happened_;  // in the session of the attempt, and not recorded yet
  TouchWatch touch_watch_;
  InputKindWatch input_;
  double now_s_ = 0.0;  // time in use since log_ began
  double view_written_s_ = -1.0, atoms_written_s_ = -1.0;
  std::optional<InputChanged> way_;
  std::optional<StageChanged> stage_;
  std::optional<AtomsMoved> atoms_;
  std::optional<Camera> view_;
  bool paused_ = false, mending_begun_ = false;
  std::future<std::size_t> mended_;
};

}  // namespace moltact
