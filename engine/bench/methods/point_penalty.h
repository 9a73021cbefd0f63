// A penalty method for a rigid body, after the pointshells of McNeely, Puterbaugh & Troy (1999). Each atom of the body is
// a point against the scene's spheres, which are inflated by the atom's radius. A point inside such a sphere is pushed
// outward along the sphere's normal, in proportion to its depth. The forces and torques of all points are summed. The
// springs between body and hand are those of the exact body. The body has no mass: each tick moves it to the balance of
// all springs (quasi-static, as in Wan & McNeely 2003), i.e. to a local minimum of
//   E / k = |x - x_hand|^2 / 2 + L^2 |theta|^2 / 2 + kContact sum(depth^2) / 2,   theta = log(q_hand q^-1),
// by Newton's method from the last pose, with halved steps where E would rise.
//
// Known limitations: the body overlaps the scene by the force over the contact's stiffness. The path between two poses is
// not examined, so that a fast hand passes through thin walls. Deep inside, the pushes of opposite sides cancel. Haptic
// thread; no allocation after construction. Units: angstrom, radian.
#pragma once

#include <array>
#include <memory>

#include "engine/haptics/body/body_pairs.h"
#include "engine/haptics/body/six.h"
#include "engine/haptics/interaction.h"

namespace moltact::bench {

class PointPenalty final : public Interaction {
 public:
  /// Default stiffness of a point's push, as a multiple of that of the spring at the hand. docs/exact-body.md compares
  /// others.
  static constexpr double kContact = 10.0;
  static constexpr int kMaxSteps = 30;  ///< of Newton's method per tick

  /// `body` must not be null. `rotational_A2` is L^2; 0: the square of the body's radius of gyration. `contact`: the
  /// stiffness of a push, as kContact.
  PointPenalty(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body,
               double rotational_A2 = 0.0, double contact = kContact);

  /// Contact::scp is the body's middle; atoms and normals are those of the three deepest points. `at_rest` is false where
  /// Newton's method has not converged.
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  MemoryUsage memoryUsage() const noexcept override;
  bool hasOrientation() const noexcept override { return true; }

  double lever_A() const noexcept { return lever_; }  ///< L
  /// E / k of the body at its present pose for another hand.
  double energyFor_A2(const PoseA& hand) noexcept;

 private:
  // E / k at a pose, its negative gradient and its Hessian.
  struct Balance {
    double energy = 0.0;
    Six pull;
    Matrix6 curvature;
    int touching = 0;        // points inside a sphere
    double least_gap = 1e9;  // of the other listed pairs
  };
  struct Push {
    double depth = 0.0;
    std::int32_t atom = -1;
    Vec3 normal{0.0};
  };
  Balance balanceAt(const BodyPose& at, const BodyPose& hand) noexcept;
  BodyPose relative(const PoseA& pose) const noexcept { return {pose.place.A - pairs_.origin(), pose.orientation}; }
  Response refused(const PoseA& pose, Fault fault) const noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  std::shared_ptr<const HeldBody> body_;
  BodyPairs pairs_;
  double lever_, contact_;
  bool armed_ = false;
  BodyPose pose_;
  BodyPose free_from_;
  double free_room_ = 0.0;         // no contact for a hand that moves by less than this from free_from_
  std::array<Push, 3> deepest_{};  // at the pose of the last balanceAt, in descending order
};

}  // namespace moltact::bench
