// Methods without a molecule, for trying a device: what they feel like is known beforehand. Haptic thread. Units:
// angstrom.
#pragma once

#include "engine/haptics/tracker.h"

namespace moltact {

class PlainTracker : public Tracker {
 public:
  void reset() noexcept override {}
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return kWaterProbe_A; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }
};

/// Pulls along x with a force that does not depend on the place: the spring is stretched by `stretch_A` wherever the
/// hand is.
class PullTracker final : public PlainTracker {
 public:
  explicit PullTracker(double stretch_A) : stretch_A_(stretch_A) {}
  Contact step(PointA hip) noexcept override {
    return {.scp = {hip.A + Vec3(stretch_A_, 0, 0)}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
  }

 private:
  double stretch_A_;
};

/// A wall at that z that faces +z.
class WallTracker final : public PlainTracker {
 public:
  explicit WallTracker(double z_A) : z_A_(z_A) {}
  Contact step(PointA hip) noexcept override {
    if (hip.A.z >= z_A_) return {.scp = hip};
    return {.scp = {{hip.A.x, hip.A.y, z_A_}}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
  }

 private:
  double z_A_;
};

}  // namespace moltact
