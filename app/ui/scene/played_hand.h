// The hand of an attempt that is played back: one sample, shown in place of the hand's own until the next one. Window's
// thread.
#pragma once

#include <optional>

#include "app/ui/scene/felt_scene.h"

namespace moltact {

class PlayedHand {
 public:
  explicit PlayedHand(FeltScene& felt) : felt_(felt) {}

  /// Shows this sample from now on: the log contains it, and there is no force. Empty: the hand's own again, from
  /// outside.
  void show(const std::optional<ServoSample>& sample);
  bool on() const { return felt_.played.has_value(); }
  /// Called once per frame while it is on. Adds the sample to the log once for each tick of the frame; of a frame longer
  /// than 0.5 s, for 0.5 s.
  void advance(double dt_s);

 private:
  FeltScene& felt_;
  double owed_s_ = 0.0;
};

}  // namespace moltact
