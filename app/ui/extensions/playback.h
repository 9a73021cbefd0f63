// Plays an attempt back in the 3-D view: probe, force arrow and the words for them move as they did. The hand that
// holds the device feels nothing meanwhile, and nothing is kept. Window's thread. Unit: second of use.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/ui/application/extension.h"
#include "app/ui/scene/played_body.h"
#include "engine/render/camera.h"
#include "engine/results/timeline.h"

namespace moltact {

struct ApplicationOptions;
class AttemptRecorder;
class LessonGuide;
class Messages;
class MovingStates;
class Opener;
struct PanelState;
struct Settings;

class Playback : public Extension {
 public:
  Playback(AttemptRecorder& recorder, MovingStates& moving_states, Opener& opener, HapticSession& scene,
           LessonGuide& lesson, const Settings& settings, Messages& messages, PanelState& panels,
           const ApplicationOptions& options, const FrameTime& time)
      : opener_(opener),
        scene_(scene),
        lesson_(lesson),
        settings_(settings),
        messages_(messages),
        panels_(panels),
        options_(options),
        time_(time),
        moving_states_(moving_states),
        recorder_(recorder),
        body_(scene) {}

  /// Begins to play a file; one that cannot be read gives a message and changes nothing.
  void open(const std::filesystem::path& file);
  /// Back to the lesson or molecule that was there before; with `back` false, something else is about to be opened.
  void close(bool back = true);

  bool on() const { return timeline_.has_value(); }
  /// While on() only.
  const Timeline& timeline() const { return *timeline_; }
  double at_s() const { return at_s_; }
  bool running() const { return on() && running_; }

  /// At the end it starts from the beginning.
  void setRunning(bool run);
  void seek(double t_s);
  /// The next or the last mark before; nothing where there is none.
  void seekMark(int direction);
  /// The last event, for the bar: empty before the first mark.
  std::string lastMark() const;

  double speed = 1.0;        ///< times as fast as it was
  bool follows_view = true;  ///< the view turns as it did; off once the person turns it
  bool skips_rests = true;   ///< passes over times when the hand lay still

  void beforeOpening(FileKind kind) override;
  bool open(FileKind kind, const std::filesystem::path& file) override;
  void beforeTicks() override;
  void afterPanels() override;
  bool live() const override { return running(); }
  bool hidesLesson() const override { return on(); }

  static constexpr double kRest_s = 3.0;  ///< a longer rest is passed over

 private:
  Opener& opener_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  const Settings& settings_;
  Messages& messages_;
  PanelState& panels_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  MovingStates& moving_states_;
  AttemptRecorder& recorder_;  // rests meanwhile
  void stageFor();
  std::filesystem::path fileOf(const std::string& name);
  void showStates();
  bool staged() const;
  void showHeld();
  void showHand();
  void showView();

  std::optional<Timeline> timeline_;
  std::filesystem::path file_;                            // the attempt
  MoleculeKey before_;                                    // on the stage before
  Camera seen_before_;                                    // how that was looked at
  NamedMolecule shown_stage_;                             // asked for, by its file's name without folders
  std::pair<std::string, std::filesystem::path> second_;  // the second structure's file, as named and as found
  std::string missing_;                                   // the name of a molecule's file that was reported as missing
  const ViewChanged* shown_view_ = nullptr;
  PlayedBody body_;
  double at_s_ = 0.0;
  bool running_ = false;
};

}  // namespace moltact
