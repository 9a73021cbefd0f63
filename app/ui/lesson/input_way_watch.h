// Whether the person works with the mouse or with the keyboard just now. Window's thread.
#pragma once

#include "engine/results/attempt.h"

struct ImGuiIO;

namespace moltact {

class InputWayWatch {
 public:
  /// Once a frame, while the frame's input is known.
  void look(const ImGuiIO& io);
  InputWay way() const { return way_; }

 private:
  InputWay way_ = InputWay::Mouse;
};

}  // namespace moltact
