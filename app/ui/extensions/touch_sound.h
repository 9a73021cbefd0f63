// Plays the sound of touch, computed from every tick; silent without a sound card. Users of a mouse or keys are asked
// once, at the first touch, whether to play it. On the frames' clock the samples are stored instead of played, for
// scripts and tests. If a task asks what is touched, the sound depends only on force and speed (reveal_policy.h). A running
// playback of an attempt sounds as its touch did; a paused one is silent. Window's thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/ui/application/extension.h"
#include "app/ui/widgets/messages.h"
#include "engine/sound/touch_synth.h"

namespace moltact {

struct ApplicationOptions;
struct PanelState;
struct Settings;
class Playback;
class RevealPolicy;

class TouchSound : public Extension {
 public:
  TouchSound(const RevealPolicy& policy, const Playback& playback, const HapticSession& scene, Settings& settings,
             Messages& messages, const PanelState& panels, const ApplicationOptions& options, const FrameTime& time);
  ~TouchSound() override;

  void ticks(const FeltTicks& felt) override;
  /// Ends the contact's sound.
  void sceneChanged() override;
  /// Takes the frame's sample of a playback, and applies changes of the setting. A missing sound card is reported once each time that sound is switched on.
  void afterPanels() override;

  /// The user's answer to the question, which is not asked again.
  void answer(bool on);

  /// The samples since sound was switched on (frames' clock only, at kSamples_per_s).
  const std::vector<float>& heard() const { return heard_; }

 private:
  const RevealPolicy& policy_;
  const Playback& playback_;
  const HapticSession& scene_;
  Settings& settings_;
  Messages& messages_;
  const PanelState& panels_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  void take(const TouchMoment& moment);
  void hear(double for_s);
  void hearPlayback();
  void ask();
  void switchOnOff();

  struct Playing;
  std::unique_ptr<Playing> playing_;
  bool on_ = false, reported_ = false;
  MessageId question_ = 0;
  double felt_s_ = 0.0;         // time of touch before the question
  std::optional<Vec3> last_A_;  // the contact point in the last tick; in a playback, of the last recorded sample
  double last_s_ = 0.0;         // time of that sample in the attempt
  double slide_A_per_s_ = 0.0;  // of a playback
  bool hears_playback_ = false;
  double owed_samples_ = 0.0;  // of a playback on the frames' clock
  TouchSynth synth_;           // for the frames' clock
  std::vector<float> heard_;
};

}  // namespace moltact
