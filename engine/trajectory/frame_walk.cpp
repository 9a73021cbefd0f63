#include "engine/trajectory/frame_walk.h"

namespace moltact {

FrameStep nextPlace(const FramePlace& now, double frames, const FrameRange& range, AtEnd at_end) {
  const auto to = [](double at, int direction) { return FrameStep{FramePlace{at, direction}}; };
  if (range.last <= range.first) return {};
  const double next = now.at + double(now.direction) * frames;
  switch (at_end) {
    case AtEnd::Repeat:
      if (!range.complete && next > range.last) return {};
      // The way from the last frame to the first is as long as that between neighbours.
      return to(next >= range.last + 1.0 ? next - (range.last + 1.0 - range.first) : next, 1);
    case AtEnd::Return:
      if (next >= range.last && now.direction > 0) return range.complete ? to(range.last, -1) : FrameStep();
      if (next <= range.first && now.direction < 0) return to(range.first, 1);
      return to(next, now.direction);
    case AtEnd::Stop:
      if (next < range.last) return to(next, 1);
      if (!range.complete) return {};
      if (now.at >= range.last) return {.to = {}, .ends = true};
      return to(range.last, 1);
  }
  return {};
}

}  // namespace moltact
