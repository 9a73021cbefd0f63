// The plainest thing that can be touched: the half-space z < 0, all of it matter. What the sampled device
// makes of energy and shaking on this wall no method can be blamed for. Units: angstrom. Safe on the haptic
// thread.
#pragma once

#include <algorithm>

#include "engine/haptics/tracker.h"

namespace moltact::bench {

class PlainWall final : public Tracker {
 public:
  Contact step(PointA hip) noexcept override {
    Contact c;
    c.scp = hip;
    if (!finite(hip.A))
      c.fault = Fault::NotFinite;
    else if (hip.A.z < 0)
      c.scp.A.z = 0, c.feature = Feature::Sphere;
    return c;
  }
  void reset() noexcept override {}
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }
};

}  // namespace moltact::bench
