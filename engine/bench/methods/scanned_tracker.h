// The height field of a scanning tip (engine/haptics/height_field) as a method for the probe. A tip of the probe's
// radius scans the scene from +z, and the SCP is the tip's centre on the scanned surface. The substrate lies 1000 A
// deeper. A new probe scans the scene again on the same nodes, in a long tick.
//
// Known limitations, verified by tests: the scan contains neither overhanging flanks nor the underside, and a wall of atoms
// becomes a slope one spacing wide. A HIP there is inside until it comes out above. Between nodes the surface cuts
// creases off and lies up to spacing^2 / (4 radius) under a cap. Haptic thread; no allocation after construction.
// Units: angstrom.
#pragma once

#include <memory>
#include <optional>

#include "engine/haptics/height_field/height_field_tracker.h"
#include "engine/haptics/height_field/scanning_tip.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class ScannedTracker final : public Tracker {
 public:
  /// The spacing doubles until the scan has at most kMaxScanNodes nodes.
  ScannedTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, double spacing_A);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override { tracker_->reset(); }
  void setProbe(double probe_A) noexcept override;
  double probe_A() const noexcept override { return probe_; }
  MemoryUsage memoryUsage() const noexcept override;

 private:
  std::shared_ptr<const SphereGrid> scene_;
  double probe_;
  std::optional<ScanningTip> tip_;  // empty: there is nothing to scan
  std::optional<HeightFieldTracker> tracker_;
};

}  // namespace moltact
