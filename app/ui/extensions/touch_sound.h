// Sound for the touch: fed with every tick, silent where there is no sound card. Who feels with a mouse or keys is asked
// once, at the first touch, whether it is to be heard; it is quiet until the person wants it louder. On the frames'
// clock nothing is played; what would have been heard is kept, for scripts and tests. Where a task asks what is touched it
// goes on with the force and the speed alone (unseen.h). Window's thread.
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
class Unseen;

class TouchSound : public Extension {
 public:
  TouchSound(const Unseen& unseen, const HapticSession& scene, Settings& settings, Messages& messages,
             const PanelState& panels, const ApplicationOptions& options);
  ~TouchSound() override;

  void ticks(const FeltTicks& felt) override;
  /// The contact has ended.
  void sceneChanged() override;
  /// Sound is switched on and off; a missing sound card is reported once each time that sound is switched on.
  void afterPanels() override;

  /// The person's answer to the question; it is not asked again.
  void answer(bool on);

  /// The sound since it was switched on (frames' clock only, at kSamples_per_s).
  const std::vector<float>& heard() const { return heard_; }

 private:
  const Unseen& unseen_;
  const HapticSession& scene_;
  Settings& settings_;
  Messages& messages_;
  const PanelState& panels_;
  const ApplicationOptions& options_;
  void take(const TouchMoment& moment);
  void ask();
  void switchOnOff();

  struct Playing;
  std::unique_ptr<Playing> playing_;
  bool on_ = false, told_ = false;
  MessageId question_ = 0;
  double felt_s_ = 0.0;         // of touch, before the question
  std::optional<Vec3> last_A_;  // where the contact point was in the last tick
  TouchSynth synth_;            // of the frames' clock
  std::vector<float> heard_;
};

}  // namespace moltact
