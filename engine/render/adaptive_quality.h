// How finely the pictures of a view are drawn: on a slow machine coarser while the view turns, smooth once it rests. A
// pure calculation from the times that pictures took; one object a view.
#pragma once

#include "engine/render/renderer.h"

namespace moltact {

class AdaptiveQuality {
 public:
  /// How the next picture is to be drawn.
  struct Choice {
    double scale = 1.0;  ///< of its width and height; the picture is stretched to the view's size
    RenderOptions options;
  };

  /// Once a frame. `moving`: the view turns, so that speed counts more than sharpness.
  Choice choose(bool moving);
  /// The molecule of the picture chosen last was drawn anew in so many milliseconds.
  void took(double ms);
  /// The picture chosen last is coarser than it will be once the view has rested.
  bool unfinished() const { return unfinished_; }

 private:
  Choice last_;
  double whole_ms_ = 0.0;  // what drawing the molecule at full size with the fine light takes here; 0: not known yet
  int rested_frames_ = 0;
  bool unfinished_ = false;
};

}  // namespace moltact
