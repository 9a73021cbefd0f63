// The order of frames. Oracle: the places written out by hand.
#include "engine/trajectory/frame_walk.h"

#include <doctest/doctest.h>

#include <vector>

using namespace moltact;

namespace {

constexpr FrameRange kOneToFour{1.0, 4.0, true};

// The places of the next calls; -1: it stays, -2: it ends.
std::vector<double> walk(FramePlace now, double frames, const FrameRange& range, AtEnd at_end, int calls) {
  std::vector<double> out;
  for (int k = 0; k < calls; ++k) {
    const FrameStep step = nextPlace(now, frames, range, at_end);
    if (step.to) now = *step.to;
    out.push_back(step.to ? now.at : step.ends ? -2.0 : -1.0);
  }
  return out;
}

using Places = std::vector<double>;

}  // namespace

TEST_CASE("at the last frame the walk stops, turns round and turns again, or goes on to the first frame") {
  CHECK(walk({2.5, 1}, 1.0, kOneToFour, AtEnd::Stop, 4) == Places{3.5, 4.0, -2.0, -2.0});
  CHECK(walk({2.5, 1}, 1.0, kOneToFour, AtEnd::Return, 8) == Places{3.5, 4.0, 3.0, 2.0, 1.0, 2.0, 3.0, 4.0});
  // Frame 4.5 lies half way from the last frame to the first.
  CHECK(walk({2.5, 1}, 1.0, kOneToFour, AtEnd::Repeat, 5) == Places{3.5, 4.5, 1.5, 2.5, 3.5});
  CHECK(walk({2.0, -1}, 0.5, kOneToFour, AtEnd::Return, 4) == Places{1.5, 1.0, 1.5, 2.0});
}

TEST_CASE("while frames may follow the last one it stays before it, also on the way forward only") {
  const FrameRange open{1.0, 4.0, false};
  for (const AtEnd at_end : {AtEnd::Stop, AtEnd::Return, AtEnd::Repeat})
    CHECK(walk({3.6, 1}, 1.0, open, at_end, 2) == Places{-1.0, -1.0});
  CHECK(walk({3.6, -1}, 1.0, open, AtEnd::Return, 1) == Places{2.6});
  for (const AtEnd at_end : {AtEnd::Stop, AtEnd::Return, AtEnd::Repeat})
    CHECK(walk({1.0, 1}, 1.0, {1.0, 1.0, true}, at_end, 2) == Places{-1.0, -1.0});
}
