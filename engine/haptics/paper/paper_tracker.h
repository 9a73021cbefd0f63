// Algorithm 1 of Stocks & Laycock (2008) as published, including the three cases of its Figure 4 and its faults.
// docs/paper-algorithm.md explains the interpretation of unclear passages and the resulting faults. `step` runs on the
// haptic thread. Units: angstrom.
#pragma once

#include <memory>
#include <optional>

#include "engine/haptics/paper/atom_models.h"
#include "engine/haptics/paper/intersection_point.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class PaperTracker final : public Tracker {
 public:
  /// The paper's epsilon, for which it gives no value (unit: angstrom). The planes of an intersection point are tested
  /// while the SCP is nearer to the point than this. A hand at 100 mm/s with 0.25 A/mm moves 0.025 A per tick and
  /// cannot step across. The two points of three atoms are usually separated by at least 1 A.
  static constexpr double kEpsilon_A = 0.1;

  /// `scene` must not be null (asserted). The probe is clamped as in setProbe; a non-finite radius becomes
  /// kWaterProbe_A.
  PaperTracker(std::shared_ptr<const SphereGrid> scene, double probe_A);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  double probe_A() const noexcept override { return probe_; }
  MemoryUsage memoryUsage() const noexcept override;

 private:
  double radius(std::int32_t atom) const { return (*scene_)[std::size_t(atom)].radius_A + probe_; }
  const Vec3& centre(std::int32_t atom) const { return (*scene_)[std::size_t(atom)].centre_A; }
  std::int32_t deepestAtomAround(const Vec3& hip) const;
  bool insideSphere(std::int32_t atom, const Vec3& hip) const;
  std::optional<paper::Cone> coneOf(std::int32_t atom, std::int32_t neighbour) const;

  void constrainToSphere(const Vec3& hip);
  void findCone(const Vec3& hip);
  void findPoint(const Vec3& hip);
  void leavePoint(const Vec3& hip);
  void followCone(const Vec3& hip);
  Contact contact(PointA hip) const;

  std::shared_ptr<const SphereGrid> scene_;
  double probe_ = kWaterProbe_A;
  paper::AtomModels models_;

  bool has_been_outside_ = false;
  Feature state_ = Feature::Free;
  std::int32_t atom_ = -1;     // the paper's current Atom; valid in contact
  paper::Cone cone_;           // the current Cone; valid in state Circle
  paper::PointVolume volume_;  // the current Point; valid in state Point
  Vec3 scp_{0.0};
};

}  // namespace moltact
