// The order in which the frames of a trajectory are played: forward, and at the last frame a stop, the way back, or the
// first frame again. A place is a frame's number with a fraction. Any thread.
#pragma once

#include <optional>

namespace moltact {

/// What follows on the last frame: nothing; the way back; the first one, to which the atoms move as to any next frame.
enum class AtEnd { Stop, Return, Repeat };

struct FramePlace {
  double at = 0.0;    ///< past the last frame on the way back to the first
  int direction = 1;  ///< 1 or -1
};

/// The frames that are played.
struct FrameRange {
  double first = 0.0, last = 0.0;
  bool complete = true;  ///< false: frames may be found after the last one
};

struct FrameStep {
  std::optional<FramePlace> to;  ///< empty: it stays
  bool ends = false;             ///< it has arrived where it stops
};

/// The place after `frames` (not negative) more frames. It turns round at an end, and stays at the end of a range that is
/// not complete, and in one of a single frame.
FrameStep nextPlace(const FramePlace& now, double frames, const FrameRange& range, AtEnd at_end);

}  // namespace moltact
