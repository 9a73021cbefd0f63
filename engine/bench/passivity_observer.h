// A passivity observer after Hannaford & Ryu (2002): measures energy that a virtual object has returned without
// receiving it. Units: joule, newton, metre. Plain arithmetic, usable on every thread.
//
// It needs no model of the object's stored energy. At a release, a moment with neither contact nor force, nothing is
// stored, whatever the method. Let F be the force on the device. If the object is passive, the energy given to the
// device, sum(F . dx), does not increase from one release to a later one; the largest increase is generated energy.
// Between releases nothing is judged: an apparent gain may be stored energy known only to the method, such as the sum
// over all spheres of a penalty.
#pragma once

#include <algorithm>
#include <limits>

#include "engine/core/units.h"

namespace moltact::bench {

class PassivityObserver {
 public:
  /// Adds a motion: the mean force on the device during it, and true if everything is released at its end.
  void add(const Vec3& force_N, const Vec3& moved_m, bool released) { addWork(glm::dot(force_N, moved_m), released); }
  /// The same for energy given to the device otherwise (unit: J).
  void addWork(double given_J, bool released) {
    given_ += given_J;
    if (released) release();
  }

  /// The object is released at the present position, before the first motion.
  void release() {
    lowest_ = std::min(lowest_, given_);
    made_ = std::max(made_, given_ - lowest_);
  }

  double made_J() const { return made_; }

 private:
  double given_ = 0, lowest_ = std::numeric_limits<double>::infinity(), made_ = 0;
};

}  // namespace moltact::bench
