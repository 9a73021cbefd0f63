// A passivity observer after Hannaford & Ryu (2002): how much energy a virtual thing has given that it never
// got. Units: joule, newton, metre. Plain arithmetic, usable on every thread.
//
// Absorbed energy is -sum(F . dx), F the force on the device. A spring gives back what it has stored, so the
// energy made out of nothing is the greatest rise of (stored - absorbed) over its lowest value so far: a
// passive thing lets it only fall. Without a known store (stored = 0 whenever nothing touches) the observer
// is the published one at each release.
#pragma once

#include <algorithm>

#include "engine/core/units.h"

namespace moltact::bench {

class PassivityObserver {
 public:
  /// One tick: the force on the device while it moved, and what the spring holds afterwards.
  void add(const Vec3& force_N, const Vec3& moved_m, double stored_J) {
    absorbed_ -= glm::dot(force_N, moved_m);
    const double balance = stored_J - absorbed_;
    lowest_ = std::min(lowest_, balance);
    made_ = std::max(made_, balance - lowest_);
  }

  double absorbed_J() const { return absorbed_; }
  double made_J() const { return made_; }

 private:
  double absorbed_ = 0, lowest_ = 0, made_ = 0;
};

}  // namespace moltact::bench
