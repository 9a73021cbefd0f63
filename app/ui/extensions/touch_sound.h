// Sound for the touch: switched on at will, fed with every tick, silent where there is no sound card. On the frames'
// clock nothing is played; what would have been heard is kept, for scripts and tests. It goes on while the screen is
// dark: the force, the kind of place and the passing from one set of atoms to another are what a hand feels too, and no
// atom is said by its name or element. Window's thread.
#pragma once

#include <memory>
#include <vector>

#include "app/ui/application/extension.h"
#include "engine/sound/touch_synth.h"

namespace moltact {

class TouchSound : public Extension {
 public:
  TouchSound();
  ~TouchSound() override;

  void ticks(Application& app, const FeltTicks& felt) override;
  /// The contact has ended.
  void sceneChanged(Application& app) override;
  /// Sound is switched on and off; a missing sound card is reported once each time that sound is switched on.
  void afterPanels(Application& app) override;

  /// The sound since it was switched on (frames' clock only, at kSamples_per_s).
  const std::vector<float>& heard() const { return heard_; }

 private:
  void take(const TouchMoment& moment);

  struct Playing;
  std::unique_ptr<Playing> playing_;
  bool on_ = false, told_ = false;
  TouchSynth synth_;  // of the frames' clock
  std::vector<float> heard_;
};

}  // namespace moltact
