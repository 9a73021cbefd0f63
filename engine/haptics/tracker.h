// The interface of every haptic method: input is the HIP, output the surface contact point (SCP). A tracker is felt as
// a sphere at the hand, the probe. The force acts through the sphere's centre, whatever the hand's orientation. `step`
// runs on the haptic thread: no lock, allocation, exception, log or system call. Units: angstrom.
#pragma once

#include "engine/haptics/interaction.h"

namespace moltact {

class Tracker : public Interaction {
 public:
  /// Performs one tick: moves the SCP for the new HIP (unit: angstrom). Non-finite input gives Fault::NotFinite. In
  /// contact a surface moved by setProbe() or advanceTo() carries the SCP along.
  virtual Contact step(PointA hip) noexcept = 0;

  Response respond(const PoseA& pose) noexcept override { return {.contact = step(pose.place)}; }
};

}  // namespace moltact
