// The hand of an attempt in playback. Until the next sample of the attempt arrives, its newest one replaces the samples
// of the real hand. Window's thread.
#pragma once

#include <optional>

#include "app/ui/scene/felt_scene.h"

namespace moltact {

class PlayedHand {
 public:
  explicit PlayedHand(FeltScene& felt) : felt_(felt) {}

  /// Every tick of the log is this sample, and no force is output. Empty: the real hand is felt again, as if it came from
  /// outside the molecule.
  void show(const std::optional<ServoSample>& sample);
  bool on() const { return felt_.played.has_value(); }
  /// Called once per frame while it is on. Adds the sample to the log once for each tick of the frame, for at most 0.5 s
  /// of a frame.
  void advance(double dt_s);

 private:
  FeltScene& felt_;
  double owed_s_ = 0.0;
};

}  // namespace moltact
