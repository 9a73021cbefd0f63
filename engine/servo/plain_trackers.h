// Trackers without a molecule and with known force, for testing a device. Haptic thread. Units: angstrom.
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

/// A constant force along x, independent of the position: the spring's extension is always `stretch_A`.
class ConstantForceTracker final : public PlainTracker {
 public:
  explicit ConstantForceTracker(double stretch_A) : stretch_A_(stretch_A) {}
  Contact step(PointA hip) noexcept override {
    Contact out{.scp = {hip.A + Vec3(stretch_A_, 0, 0)}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    // The stored energy is constant, so the work has no source; the safety stage reports its amount.
    stretchToScp(out, hip);
    out.normals[0] = Vec3(1, 0, 0);
    return out;
  }

 private:
  double stretch_A_;
};

/// A wall at z = z_A: the half-space below it is solid, and its normal is +z. Energy generated or vibration on this
/// wall is caused by the sampled device, not by a method.
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
