#include "engine/bench/methods/scanned_tracker.h"

#include <vector>

#include "engine/haptics/hip_input.h"

namespace moltact {

ScannedTracker::ScannedTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, double spacing_A)
    : scene_(std::move(scene)), probe_(usableProbe_A(probe_A, kWaterProbe_A)) {
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < scene_->size(); ++i) spheres.push_back((*scene_)[i]);
  // A margin for larger probes; the substrate is out of the way.
  constexpr double kSpare_A = 2.0, kBelow_A = 1000.0;
  ScanSetup setup{.tip_A = probe_, .spacing_A = spacing_A, .margin_A = probe_ + kSpare_A, .below_A = kBelow_A};
  for (; !spheres.empty() && !tip_ && setup.spacing_A <= kMaxScanSpacing_A; setup.spacing_A *= 2.0)
    if (auto tip = ScanningTip::over(spheres, setup, scene_->untouchable())) tip_ = *std::move(tip);
  if (tip_) tip_->scanAll();
  // The tracker shares the field of tip_, which lives as long.
  tracker_.emplace(tip_ ? std::shared_ptr<const HeightField>(scene_, &tip_->field()) : nullptr, probe_);
}

// The field names the atom of the nearest node, which on a steep slope may be an atom that faces another way.
Contact ScannedTracker::step(PointA hip) noexcept {
  Contact out = tracker_->step(hip);
  if (out.atoms[0] < 0) return out;
  const Vec3 from_atom = out.scp.A - (*scene_)[static_cast<std::size_t>(out.atoms[0])].centre_A;
  if (glm::dot(out.normals[0], from_atom) > 0.0) return out;
  out.atoms[0] = -1;
  out.normals[0] = Vec3(0.0);
  return out;
}

void ScannedTracker::setProbe(double probe_A) noexcept {
  const double wanted = usableProbe_A(probe_A, probe_);
  if (wanted == probe_) return;
  probe_ = wanted;
  if (!tip_) return;
  tip_->restart(probe_);
  tip_->scanAll();
  tracker_->surfaceChanged(probe_);
}

MemoryUsage ScannedTracker::memoryUsage() const noexcept {
  MemoryUsage out = tracker_->memoryUsage();
  out.bytes += scene_->bytes();
  if (tip_) out.atoms_modelled = scene_->size();
  return out;
}

}  // namespace moltact
