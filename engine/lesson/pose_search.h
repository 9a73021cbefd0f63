// Searches a free path of a rigid body among the spheres of a scene. A tree of poses grows from a start until one pose
// is reached or the budget of tests is used up. The method is the rapidly exploring random tree (LaValle & Kuffner
// 2001), with random steps from sparse regions. A path that is found is free; that none is found proves nothing. For
// the planning of demonstrations, not for the haptic thread. Units: angstrom, radian.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

/// The poses of a body in which it overlaps no sphere of the scene. Both arguments must outlive it.
class PoseSpace {
 public:
  PoseSpace(const SphereGrid& scene, const HeldBody& body);

  /// The gap between body and scene: negative where they overlap. Exact between 0 and kFar_A; a larger gap is reported
  /// as kFar_A or more, an overlap as some negative number.
  double gap_A(const PoseA& pose) const;
  bool isFree(const PoseA& pose) const { return gap_A(pose) >= kClear_A; }
  /// Whether the body stays free while place and orientation change evenly together, as a HandWay leads it. The path
  /// is tested at places between which no sphere moves farther than the gap there, or kFinest_A where the gap is
  /// smaller.
  bool isFreeBetween(const PoseA& from, const PoseA& to) const;
  /// A pose outside the scene's bounding box to which the body gets from here along a straight free path; false where
  /// none of the directions that are tried is open.
  bool leadsOutside(const PoseA& from, PoseA& outside) const;

  /// A bound of how far any sphere of the body moves between two poses.
  double motion_A(const PoseA& from, const PoseA& to) const;
  /// The radius of gyration of the spheres' centres, by which rotations are compared with translations; at least 1 A.
  double gyration_A() const { return gyration_; }
  std::uint64_t tests() const { return tests_; }  ///< number of poses tested so far

  static constexpr double kFar_A = 2.0, kClear_A = 1e-3, kFinest_A = 0.05;

 private:
  double fieldAt(const Vec3& place) const;

  const SphereGrid& scene_;
  const HeldBody& body_;
  double lever_ = 0.0, gyration_ = 1.0;
  // For each voxel, a lower bound of the distance from any point of it to the nearest surface, at most kFar_A plus the
  // largest radius of the body.
  Vec3 low_{0.0};
  double voxel_ = 0.5, cap_ = 0.0;
  std::size_t nx_ = 0, ny_ = 0, nz_ = 0;
  std::vector<float> field_;
  mutable std::uint64_t tests_ = 0;
};

struct PoseSearch {
  /// Whether a pose may be part of the path; empty: every free pose.
  std::function<bool(const PoseA&)> allowed = {};
  /// Whether a pose is the goal; empty: the body has left the scene.
  std::function<bool(const PoseA&)> reached = {};
  double reach_A = 30.0;  ///< the tree is drawn to places within this distance of the start
  std::uint64_t seed = 1;
  std::uint64_t max_tests = 400'000;  ///< budget of tested poses
};

/// A free path from `start`, which must be free, to a pose that is reached: its corners, the first and the last
/// included. Empty if none was found. The same arguments give the same path.
std::vector<PoseA> freePath(const PoseSpace& space, const PoseA& start, const PoseSearch& search);

/// An orientation, each as likely as any other (Shoemake 1992).
Quat randomOrientation(std::uint64_t& random);

}  // namespace moltact
