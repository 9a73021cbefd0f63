// Plays an attempt in the 3-D view with its probe, force arrow and texts. During the playback the device outputs no
// force and nothing is recorded. Window's thread. Unit: second, on the time axis of Timeline.
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
class AtomMovers;
class Opener;
struct PanelState;
struct Settings;

class Playback : public Extension {
 public:
  Playback(AttemptRecorder& recorder, const AtomMovers& movers, Opener& opener, HapticSession& scene,
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
        movers_(movers),
        recorder_(recorder),
        motion_(scene.atoms().owner, MotionRank::Playback),
        body_(scene) {}

  /// Starts the playback of a file. An unreadable file causes a message and changes nothing else.
  void open(const std::filesystem::path& file);
  /// Ends the playback and returns to the previous lesson or molecule. `back` false: something else is about to be
  /// opened.
  void close(bool back = true);

  bool on() const { return timeline_.has_value(); }
  /// Requires on().
  const Timeline& timeline() const { return *timeline_; }
  double at_s() const { return at_s_; }
  bool running() const { return on() && running_; }

  /// Starts or pauses the playback. At the end of the attempt, it restarts from the beginning.
  void setRunning(bool run);
  void seek(double t_s);
  /// Moves to the next (direction > 0) or previous mark; without one, to the end or the start.
  void seekMark(int direction);
  /// The text of the mark last passed, for the bar; empty before the first mark.
  std::string lastMark() const;

  double speed = 1.0;        ///< relative to the recorded speed
  bool follows_view = true;  ///< follows the recorded view; off once the user rotates the view
  bool skips_rests = true;   ///< skips periods without motion of the hand

  void beforeOpening(FileKind kind) override;
  bool open(FileKind kind, const std::filesystem::path& file) override;
  void beforeTicks() override;
  void afterPanels() override;
  bool live() const override { return running(); }
  bool hidesLesson() const override { return on(); }

  static constexpr double kRest_s = 3.0;  ///< longer periods without motion are skipped

 private:
  Opener& opener_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  const Settings& settings_;
  Messages& messages_;
  PanelState& panels_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  const AtomMovers& movers_;
  AttemptRecorder& recorder_;  // paused during the playback
  MotionSource motion_;        // owns the atoms during the playback
  void stageFor();
  std::filesystem::path fileOf(const std::string& name);
  void showAtoms();
  bool staged() const;
  void showHeld();
  void showHand();
  void showView();

  std::optional<Timeline> timeline_;
  std::filesystem::path file_;                           // the attempt
  MoleculeKey before_;                                   // the molecule before the playback
  Camera seen_before_;                                   // the camera before the playback
  NamedMolecule shown_stage_;                            // the requested molecule, by file name without folders
  std::pair<std::string, std::filesystem::path> moved_;  // the mover's file: name in the attempt, path found
  std::string missing_;                                  // the last molecule's file reported as missing
  std::string unknown_mover_;                            // the last one reported as unknown
  const ViewChanged* shown_view_ = nullptr;
  PlayedBody body_;
  double at_s_ = 0.0;
  bool running_ = false;
};

}  // namespace moltact
