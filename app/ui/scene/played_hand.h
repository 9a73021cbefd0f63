// The hand of an attempt that is played back: one sample, shown in place of the hand's own until the next one. Window's
// thread.
#pragma once

#include <optional>

#include "app/ui/scene/touch_log.h"

namespace moltact {

class PlayedHand {
 public:
  /// Shows this sample from now on; empty: the hand's own again.
  void show(const std::optional<ServoSample>& sample) { sample_ = sample; }
  explicit operator bool() const { return sample_.has_value(); }
  /// Adds the sample to the log once for each tick of the frame; of a frame longer than 0.5 s, for 0.5 s. Requires a
  /// sample.
  void addTo(TouchLog& log, double dt_s);

 private:
  std::optional<ServoSample> sample_;
  double owed_s_ = 0.0;
};

}  // namespace moltact
