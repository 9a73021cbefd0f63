// The pairs of a held body's sphere and a scene's sphere whose surfaces are near each other, in two lists: `far` within
// 1.6 A, `near` within 0.4 A and made from it. A list stays in use while the motion of the body and of the scene's
// spheres since it was made is smaller than its range. The next far list is made ahead, in slices over several ticks, so
// that the work of a tick is bounded by count however large the body is. A tree of bounding spheres over the body excludes
// the parts that are far from the scene. Haptic thread; no allocation after construction. Units: angstrom. Positions are
// relative to origin(), which preserves precision in a scene far from the zero point.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/sphere_motion.h"

namespace moltact {

/// The position of a body's middle and its orientation, also as a matrix.
struct BodyPose {
  Vec3 place{0.0};
  Quat orientation = kNoRotation;
  glm::dmat3 axes{1.0};

  BodyPose() = default;
  BodyPose(const Vec3& at, const Quat& oriented)
      : place(at), orientation(glm::normalize(oriented)), axes(glm::mat3_cast(orientation)) {}
};

/// Upper bound of the motion of a point of the body that is at most `reach_A` from its middle.
inline double surfaceMotion_A(const BodyPose& from, const BodyPose& to, double reach_A) {
  // The chord of a rotation by an angle is 2 sin(angle / 2) <= 2 |difference of the quaternions|.
  const Quat &p = from.orientation, &q = to.orientation;
  const Quat minus = q - p, plus = q + p;
  return glm::distance(from.place, to.place) +
         2.0 * reach_A * std::sqrt(std::min(glm::dot(minus, minus), glm::dot(plus, plus)));
}

/// A sphere of the body beside a sphere of the scene.
struct BodyPair {
  Vec3 centre;          ///< of the scene's sphere at present
  double radii = 0.0;   ///< sum of both radii
  std::int32_t sphere;  ///< of the body: index in spheres()
  std::int32_t atom;    ///< of the scene
};

class BodyPairs {
 public:
  static constexpr std::size_t kMaxFar = 16384, kMaxNear = 512;
  static constexpr double kFar_A = 1.6, kNear_A = 0.4;
  /// Spheres, pairs and nodes that a tick examines at most for its lists, but for those of the last item that it begins:
  /// kMaxWork, or kWorkPerSphere for each sphere of a larger body. While the next far list is not needed yet, a tick spends
  /// at most kSlice on it.
  static constexpr std::uint64_t kMaxWork = 9'000, kWorkPerSphere = 12, kSlice = 3'000;

  BodyPairs(std::shared_ptr<const SphereGrid> scene, const HeldBody& body);

  const Vec3& origin() const noexcept { return origin_; }
  /// Spheres of the body relative to its middle, in the order of the pairs' indices.
  std::span<const Sphere> spheres() const noexcept { return spheres_; }
  /// The index in HeldBody::spheres of a pair's sphere.
  std::int32_t indexInBody(std::int32_t sphere) const noexcept { return order_[std::size_t(sphere)]; }
  double reach_A() const noexcept { return reach_; }  ///< largest distance of a sphere's centre from the middle

  static constexpr std::uint64_t kUnlimited = ~std::uint64_t{0};
  std::uint64_t maxWork() const noexcept { return max_work_; }
  /// Begins a tick: look() may do so much work from now on.
  void beginTick() noexcept { beginTick(max_work_); }
  void beginTick(std::uint64_t work) noexcept {
    tick_end_ = work == kUnlimited ? kUnlimited : work_count_ + work;
    ahead_left_ = kSlice;
  }
  /// Brings the lists up to date for a pose, as far as the tick's work allows.
  void look(const BodyPose& pose) noexcept;
  /// True if the tick's work is done and look() would have made a list.
  bool exhausted() const noexcept { return exhausted_; }
  std::span<const BodyPair> near() const noexcept { return {near_.data(), near_count_}; }
  /// After look(): every pair that is not in near() has at least this gap at the pose, and during a motion of the body
  /// by less than it.
  double covered_A(const BodyPose& pose) const noexcept {
    return near_range_ - surfaceMotion_A(near_pose_, pose, reach_) - sceneMotion_A(near_fraction_);
  }
  /// A lower bound of the gap between the body as a whole and the scene, from its bounding sphere.
  double clearance_A(const BodyPose& pose) const noexcept;
  /// True if a sphere of the body overlaps one of the scene.
  bool overlaps(const BodyPose& pose) const noexcept;

  void setMotion(const SphereMotion* motion) noexcept;
  bool has(const SphereMotion* motion) const noexcept { return (motion ? motion->serial() : 0) == motion_serial_; }
  void advanceTo(double fraction) noexcept;
  double fraction() const noexcept { return fraction_; }
  /// Upper bound of the motion of a listed sphere during the whole motion.
  double maxMotion_A() const noexcept {
    return !motion_ ? 0.0 : far_.motion == motion_serial_ ? far_.max_motion : motion_->maxMotion_A();
  }

  std::size_t farCount() const noexcept { return far_.count; }
  /// Spheres, pairs and nodes examined since the start.
  std::uint64_t workCount() const noexcept { return work_count_; }
  std::size_t bytes() const noexcept;

 private:
  struct Node {
    Vec3 centre{0.0};  // in the body's axes
    double radius = 0.0;
    std::int32_t begin = 0, end = 0;  // range in spheres_
    std::int32_t next = 0;            // the next node outside this subtree
    bool leaf = false;
    // At `seen_from` (the node's centre) every sphere of the scene was at least `clear` from the node's sphere.
    Vec3 seen_from{0.0};
    double clear = -1.0;
    double search = 0.0;  // how far the next search looks
  };
  const SphereGrid& grid() const noexcept { return motion_ ? motion_->sweptSpheres() : *scene_; }
  Sphere now(std::int32_t atom) const noexcept {
    const Sphere b = motion_ ? (*motion_)[std::size_t(atom)].at(fraction_) : (*scene_)[std::size_t(atom)];
    return {b.centre_A - origin_, b.radius_A};
  }
  double sceneMotion_A(double since) const noexcept { return std::abs(fraction_ - since) * maxMotion_A(); }
  template <class Nodes, class Excludes, class Visit>
  bool walk(Nodes& nodes, const BodyPose& pose, Excludes excludes, Visit visit) const noexcept;
  double nodeClearance_A(Node& node, const Vec3& centre, double range) noexcept;
  void makeTree(std::span<const Sphere> body, std::int32_t begin, std::int32_t end);
  bool gatherNear(const BodyPose& pose, double range) noexcept;
  void refresh() noexcept;
  double farRange_A(const BodyPose& pose) const noexcept;
  void beginNext(const BodyPose& pose, double range) noexcept;
  bool buildNext(std::uint64_t until) noexcept;
  void takeNext() noexcept;

  // The pairs within `range` of each other at `pose`; during a motion those that come within it at any time of the motion
  // `motion`. `carried`: how far the spheres may have moved in whole motions since.
  struct FarList {
    std::vector<BodyPair> pairs;  // allocated for kMaxFar
    std::size_t count = 0;
    BodyPose pose;
    double range = -1.0, carried = 0.0, max_motion = 0.0;
    std::uint64_t motion = 0;
  };

  std::shared_ptr<const SphereGrid> scene_;
  Vec3 origin_;
  std::vector<Sphere> spheres_;
  std::uint64_t max_work_ = kMaxWork;
  std::vector<std::int32_t> order_;   // of spheres_: their indices in the body
  double reach_ = 0.0, bound_ = 0.0;  // of the centres; of the whole body
  std::vector<Node> nodes_;           // in preorder

  const SphereMotion* motion_ = nullptr;
  std::uint64_t motion_serial_ = 0;
  double fraction_ = 0.0;
  bool stale_ = false;   // the scene's spheres have moved since refresh()
  bool urgent_ = false;  // nothing is known of the spheres of a new motion: a list is made at once

  FarList far_, next_;
  bool building_ = false;
  double fits_ = kFar_A;                       // range of the next list: where the last did not fit, twice what did
  std::int32_t at_node_ = 0, at_sphere_ = -1;  // where buildNext() goes on; at_sphere_ < 0: at the node itself
  std::vector<BodyPair> near_;                 // allocated for kMaxNear
  std::size_t near_count_ = 0;
  std::vector<std::int32_t> near_from_;  // index in far_ of each entry of near_
  BodyPose near_pose_;
  double near_range_ = -1.0, near_fraction_ = 0.0;
  std::uint64_t work_count_ = 0, tick_end_ = kUnlimited, next_from_ = 0, last_work_ = 0;
  std::uint64_t ahead_left_ = 0;  // of kSlice in this tick
  bool exhausted_ = false;
};

}  // namespace moltact
