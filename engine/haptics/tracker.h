// The interface of every haptic method: input is the HIP, output the surface contact point (SCP). A tracker is felt as
// a sphere at the hand, the probe. The force acts through the sphere's centre, whatever the hand's orientation. `step`
// runs on the haptic thread: no lock, allocation, exception, log or system call. Units: angstrom.
//
// `step` stays a virtual function beside `respond`. With `respond` as the only one, `step` reads the contact from a
// Response, which is 336 bytes long. tracker_benchmark then measures 7.7 ns in place of 6.3 for exact/free/3000 (23 %
// more), 44.8 in place of 44.2 for exact/contact/3000 and 48.4 in place of 47.2 for exact/contact/14000. A call of
// `penalty` also computes the stiffness that only the servo loop reads: penalty/contact/3000 takes 126 ns in place of 51.
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
