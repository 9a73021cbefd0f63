// The one interface of every haptic method: the HIP goes in, the surface contact point comes out. A tracker is felt as
// a sphere at the hand, the probe: however the hand is turned, the force leads through its middle. `step` runs on the
// haptic thread: it neither allocates nor locks, throws, logs or calls the system. Units: angstrom.
#pragma once

#include "engine/haptics/interaction.h"

namespace moltact {

class SphereFrame;

class Tracker : public Interaction {
 public:
  /// One tick: moves the SCP for the new HIP (unit: angstrom). Non-finite input gives Fault::NotFinite. While touching
  /// the SCP is carried along with a surface that setProbe() moves.
  virtual Contact step(PointA hip) noexcept = 0;

  /// Spheres that move: from now on they are the frame's, at its beginning; null: those that the tracker was made with.
  /// The frame has as many and stays until another is set. False, with nothing changed, where the method cannot follow.
  virtual bool setFrame(const SphereFrame*) noexcept { return false; }
  /// The spheres go evenly to where they are at this share (0 to 1) of the frame, and the SCP with the surface.
  virtual void moveTo(double /*share*/) noexcept {}

  Response respond(const PoseA& pose) noexcept final { return {.contact = step(pose.place)}; }
};

}  // namespace moltact
