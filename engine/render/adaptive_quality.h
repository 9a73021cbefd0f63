// Adapts the resolution of a view to the machine: on a slow one coarser while the view moves, full once it rests. A
// pure computation from measured drawing times; one object per view.
#pragma once

#include "engine/render/renderer.h"

namespace moltact {

class AdaptiveQuality {
 public:
  /// How to draw the next picture.
  struct Choice {
    double scale = 1.0;  ///< of width and height; the picture is then stretched to the view's size
    RenderOptions options;
  };

  /// Call once per frame. `moving`: the view moves, so speed has priority over sharpness.
  Choice choose(bool moving);
  /// Reports the time for drawing the molecule of the last chosen picture.
  void took(double ms);
  /// True if the last chosen picture is coarser than it will be when the view rests.
  bool unfinished() const { return unfinished_; }

 private:
  Choice last_;
  double whole_ms_ = 0.0;  // time for the molecule at full size with fine light; 0: unknown
  int rested_frames_ = 0;
  bool unfinished_ = false;
};

}  // namespace moltact
