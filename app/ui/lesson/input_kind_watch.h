// Determines whether the user currently works with the mouse or with the keyboard. Window's thread.
#pragma once

#include "engine/results/attempt.h"

struct ImGuiIO;

namespace moltact {

class InputKindWatch {
 public:
  /// Called once per frame while the frame's input is available.
  void look(const ImGuiIO& io);
  InputKind kind() const { return kind_; }

 private:
  InputKind kind_ = InputKind::Mouse;
};

}  // namespace moltact
