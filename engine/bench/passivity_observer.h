// A passivity observer after Hannaford & Ryu (2002): the energy that a virtual object has given but never received.
// Units: joule, newton, metre. Plain arithmetic, usable on every thread.
//
// It needs no model of the energy that the object stores: at a release, a moment with neither contact nor force,
// nothing is stored, whatever the method is. The energy given to the device by then, sum(F . dx) with F the force on
// the device, may only fall from one release to a later one if the object is passive; the greatest rise is energy made
// from nothing. Between releases nothing is judged: an apparent gain there may be stored energy that only the method
// knows, such as the sum over all spheres of a penalty.
#pragma once

#include <algorithm>
#include <limits>

#include "engine/core/units.h"

namespace moltact::bench {

class PassivityObserver {
 public:
  /// One move: the mean force on the device during it, and whether all is released at its end.
  void add(const Vec3& force_N, const Vec3& moved_m, bool released) {
    given_ += glm::dot(force_N, moved_m);
    if (released) release();
  }

  /// The thing is released where it stands, before the first move.
  void release() {
    lowest_ = std::min(lowest_, given_);
    made_ = std::max(made_, given_ - lowest_);
  }

  double made_J() const { return made_; }

 private:
  double given_ = 0, lowest_ = std::numeric_limits<double>::infinity(), made_ = 0;
};

}  // namespace moltact::bench
