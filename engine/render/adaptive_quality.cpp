#include "engine/render/adaptive_quality.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr double kMoving_ms = 18.0;   // time budget for the molecule per frame while the view moves
constexpr double kSmooth_ms = 400.0;  // the same, once, after it has come to rest
constexpr int kRest_frames = 10;
constexpr double kCoarsest = 0.375;
constexpr double kFineLight = 0.5;  // below this scale the fine light is invisible and omitted

}  // namespace

AdaptiveQuality::Choice AdaptiveQuality::choose(bool moving) {
  rested_frames_ = moving ? 0 : rested_frames_ + 1;
  Choice choice;
  // The cost is proportional to the number of pixels, the square of the scale; steps of 1/8 prevent flicker. Stretching
  // softens the edges, which then need no filter.
  if (moving && whole_ms_ > kMoving_ms) {
    choice.scale = std::clamp(std::floor(8.0 * std::sqrt(kMoving_ms / whole_ms_)) / 8.0, kCoarsest, 1.0);
    choice.options.smooth_edges = choice.scale == 1.0;
    choice.options.fine_light = choice.scale >= kFineLight;
  }
  const bool smooth = 4.0 * whole_ms_ < kSmooth_ms;
  if (!moving && smooth && (rested_frames_ >= kRest_frames || last_.options.samples == 2)) choice.options.samples = 2;
  if (moving && whole_ms_ > 0 && 4.0 * whole_ms_ < kMoving_ms) choice.options.samples = 2;
  unfinished_ = !moving && smooth && choice.options.samples == 1 && whole_ms_ > 0;
  last_ = choice;
  return choice;
}

void AdaptiveQuality::took(double ms) {
  // The time of a picture without fine light does not predict that with it; using it would make the view alternate
  // between the two.
  if (!last_.options.fine_light) return;
  const double whole = ms / (last_.options.samples == 2 ? 4.0 : last_.scale * last_.scale);
  whole_ms_ = whole_ms_ > 0 ? 0.7 * whole_ms_ + 0.3 * whole : whole;
}

}  // namespace moltact
