// The interface of every haptic method: the HIP goes in, the surface contact point (SCP) comes out. A tracker is felt
// as a sphere at the hand, the probe: whatever the hand's orientation, the force acts through the sphere's centre.
// `step` runs on the haptic thread: it neither allocates nor locks, throws, logs or calls the system. Units: angstrom.
#pragma once

#include "engine/haptics/interaction.h"

namespace moltact {

class Tracker : public Interaction {
 public:
  /// One tick: moves the SCP for the new HIP (unit: angstrom). Non-finite input gives Fault::NotFinite. While touching
  /// the SCP is carried along with a surface that setProbe() or advanceTo() moves.
  virtual Contact step(PointA hip) noexcept = 0;

  Response respond(const PoseA& pose) noexcept override { return {.contact = step(pose.place)}; }
};

}  // namespace moltact
