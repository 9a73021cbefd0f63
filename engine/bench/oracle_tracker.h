// The brute-force oracle as a tracker, so that layers and motions act on it as on any method. Slow. A motion of the
// spheres gives the oracle other spheres and pushes its last SCP out of them; within a tick the surface should therefore
// move by much less than a radius. Units: angstrom.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/bench/oracle.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/tracker.h"

namespace moltact::bench {

class OracleTracker final : public Tracker {
 public:
  OracleTracker(std::vector<Sphere> spheres, double probe_A);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  double probe_A() const noexcept override { return probe_A_; }
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  MemoryUsage memoryUsage() const noexcept override { return {}; }

  /// False if one of the answers since the last call had two results (Oracle::Answer::decided).
  bool decided() noexcept;
  /// Continues from another tracker's SCP.
  void place(const Vec3& scp_A);

 private:
  std::vector<Sphere> resting_, spheres_;
  double probe_A_;
  const SphereMotion* motion_ = nullptr;
  oracle::Oracle oracle_;
  std::optional<Vec3> scp_A_;  // once the HIP has been outside
  bool decided_ = true, moved_ = false;
};

}  // namespace moltact::bench
