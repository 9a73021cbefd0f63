// Methods without a molecule, for trying a device: their feel is known beforehand. Haptic thread. Units: angstrom.
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

/// A force along x that does not depend on the place: the spring is stretched by `stretch_A` wherever the
/// hand is.
class ConstantForceTracker final : public PlainTracker {
 public:
  explicit ConstantForceTracker(double stretch_A) : stretch_A_(stretch_A) {}
  Contact step(PointA hip) noexcept override {
    Contact out{.scp = {hip.A + Vec3(stretch_A_, 0, 0)}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    // The stored energy never changes: its work comes from nothing, and the safety stage says how much it is.
    stretchToScp(out, hip);
    out.normals[0] = Vec3(1, 0, 0);
    return out;
  }

 private:
  double stretch_A_;
};

/// A wall at that z that faces +z: the half-space below it is solid. Where a sampled device makes energy or vibrates on
/// this wall, no method is at fault.
class WallTracker final : public PlainTracker {
 public:
  explicit WallTracker(double z_A) : z_A_(z_A) {}
  Contact step(PointA hip) noexcept override {
    if (!finite(hip.A)) return {.scp = hip, .fault = Fault::NotFinite};
    if (hip.A.z >= z_A_) return {.scp = hip};
    Contact out{.scp = {{hip.A.x, hip.A.y, z_A_}}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    stretchToScp(out, hip);
    out.normals[0] = Vec3(0, 0, 1);
    return out;
  }

 private:
  double z_A_;
};

}  // namespace moltact
