// The hand pulls atoms of the scene by a spring (engine/haptics/pull_spring.h) instead of touching. Window's thread.
#pragma once

#include <cstdint>
#include <vector>

#include "app/ui/scene/felt_scene.h"

namespace moltact {

class AtomPull {
 public:
  explicit AtomPull(FeltScene& felt) : felt_(felt) {}

  /// Holds these atoms at their centre of mass until called with none, or until the atoms are placed elsewhere. `masses`:
  /// one for each; empty: equal ones. Does nothing during playback, while a force is tried and with a body in the hand.
  void hold(std::vector<std::uint32_t> atoms, std::vector<double> masses = {});
  /// The atoms that are held; empty: the scene is touched.
  const std::vector<std::uint32_t>& atoms() const { return felt_.pulled; }

 private:
  FeltScene& felt_;
};

}  // namespace moltact
