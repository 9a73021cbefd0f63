// The exact rigid body in the hand: a god-object with six degrees of freedom among spheres. One spring of stiffness k
// pulls its middle to the hand and one of stiffness k_r turns it to the hand's orientation. In each tick the body moves
// along a free path from its last pose to a local minimum of
//   E / k = |x - x_hand|^2 / 2 + L^2 |log(q_hand q^-1)|^2 / 2,   L = sqrt(k_r / k),
// subject to no overlap of any of its spheres with any sphere of the scene. Force and torque are the gradient of E.
//
// Each step solves a quadratic programme with the linearized gaps as constraints. The gap of two spheres is convex in
// their distance, so the linearization is an inner approximation of free space. A bound of the rotation's second-order
// term makes the whole path of a step free (docs/exact-body.md). Constraint-based rendering with six degrees of freedom
// is due to Ortega, Redon & Coquillart (2007). Haptic thread; no allocation after construction. Units: angstrom;
// rotations in radian; six-vectors hold a translation and L times a rotation.
#pragma once

#include <array>
#include <memory>

#include "engine/haptics/body/body_pairs.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/body/six.h"
#include "engine/haptics/body/small_qp.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/slip_coupling.h"

namespace moltact {

/// Receives the way of an exact body between its ticks, for tests and the bench. Called on the thread of respond().
class BodyPathObserver {
 public:
  /// The body is placed without a path: at the start, or after it was let go.
  virtual void placed(const PoseA& at) noexcept = 0;
  /// The body moves straight: its middle along a line, its orientation about a fixed axis by less than pi. The spheres are
  /// at `fraction` of their motion meanwhile.
  virtual void moved(const PoseA& from, const PoseA& to, double fraction) noexcept = 0;
  /// The search gives up its last steps: the body is back at a pose at which it has been in this tick.
  virtual void returned(const PoseA& to) noexcept = 0;

 protected:
  ~BodyPathObserver() = default;
};

class ExactBody final : public Interaction {
 public:
  static constexpr int kMaxSteps = 40;  ///< steps per tick; beyond them the search continues in the next tick
  /// Programs and changes of their active constraints per tick, likewise; and those of a tick that moves the body out of
  /// spheres, beyond which the scene counts as closed over it.
  static constexpr int kMaxChanges = 600, kMaxSceneChanges = 1200;
  static constexpr double kSkin_A = 1e-10;  ///< spheres come no nearer than this

  /// `body` must not be null. `rotational_A2` is k_r / k = L^2 (unit: square angstrom per square radian); 0: the square
  /// of the body's radius of gyration.
  ExactBody(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body, double rotational_A2 = 0.0);

  /// Contact::scp is the body's middle. Atoms and normals are those of the up to three atoms with the largest
  /// multipliers, the feature their number. A body without contact follows the hand without force. Fault::StartedInside:
  /// the body overlaps the scene at the start, or moving spheres have closed over it; the force begins after the hand's
  /// pose has been free once.
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  /// The multipliers of the contacts, as forces along their normals. A remainder of an unfinished tick is shared in
  /// proportion.
  std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                        std::span<AtomForce> out) const noexcept override;
  std::size_t maxReactionCount() const noexcept override { return 6; }
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  MemoryUsage memoryUsage() const noexcept override;
  bool hasOrientation() const noexcept override { return true; }

  double lever_A() const noexcept { return lever_; }  ///< L
  /// The pose to which the springs pull: the hand's of the last tick, its orientation after the slip.
  PoseA coupledHand() const noexcept { return inScene(hand_); }
  int steps() const noexcept { return steps_; }  ///< of the last tick
  /// Programs and changes of active constraints in the last tick, at most kMaxSceneChanges + kMaxChanges.
  int changes() const noexcept { return changes_; }
  /// Spheres, pairs and nodes examined for the lists of pairs in the last tick (BodyPairs::maxWork).
  std::uint64_t listWork() const noexcept { return pairs_.workCount() - work_from_; }
  int contactCount() const noexcept { return held_count_; }  ///< contacts with a multiplier, at most six
  /// Reports each step from now on; null: none. The observer must outlive its use.
  void observe(BodyPathObserver* observer) noexcept { observer_ = observer; }

 private:
  // A contact of the active set.
  struct Held {
    std::int32_t sphere = -1, atom = -1;
    double lambda = 0.0;
    int row = -1;  // in rows_
  };
  // What a search may return to.
  struct Saved {
    BodyPose pose;
    std::array<Held, 6> held;
    int held_count = 0;
  };

  // exact_body.cpp
  bool armed(const PoseA& pose) noexcept;
  void followScene() noexcept;
  Response response(const PoseA& pose) const noexcept;

  // exact_body_rest.cpp: the search for the rest pose
  void seekRest() noexcept;
  bool converged(const Six& pull) const noexcept;
  bool kicked(const Six& direction, double by_A) noexcept;
  bool advance(const Six& pull) noexcept;
  bool regulated(const Factor6* metric, Six pull) noexcept;
  bool accepted(const Six& pull) const noexcept;
  bool squeezed(const Six& pull) noexcept;
  bool restored() noexcept;
  void go(const BodyPose& to) noexcept;
  PoseA inScene(const BodyPose& pose) const noexcept { return {{pairs_.origin() + pose.place}, pose.orientation}; }
  void hold(const QpSolution& solution, double part) noexcept;
  Saved saved() const noexcept { return {pose_, held_, held_count_}; }
  void returnTo(const Saved& to) noexcept;

  // exact_body_rows.cpp: gaps, energy and curvature at a pose
  void lookAround() noexcept;
  Six pull() const noexcept;
  double energyAt(const BodyPose& pose) const noexcept;
  BodyPose moved(const Six& step, double part = 1.0) const noexcept;
  double motion_A(const Six& step) const noexcept;
  QpSolution solve(const Factor6* metric, const Six& pull, double rotation_rad) noexcept;
  Matrix6 hessian(const Vec3& theta) const noexcept;
  QpSolution program(const Factor6* metric, const Six& pull, std::span<const int> preferred) noexcept;
  void lookAtMetric(const Six& pull) noexcept;
  double smallestCurvature(const Six& pull, Six& direction) const noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  std::shared_ptr<const HeldBody> body_;
  BodyPairs pairs_;
  double lever_ = 1.0;

  bool armed_ = false;  // the body has been free since the start
  bool at_rest_ = true;
  bool moved_ = false;  // the spheres have moved since the last tick
  double goal_fraction_ = 0.0;
  BodyPose pose_;  // relative to pairs_.origin(), like all positions
  BodyPose hand_;  // with the slip
  SlipCoupling coupling_;
  double free_room_ = 0.0;  // no contact for a body that moves by less than this from free_from_
  BodyPose free_from_;

  std::array<Held, 6> held_{};
  int held_count_ = 0;
  double rotation_ = 0.0;        // bound of the next step's rotation, which the constraints allow for
  double last_turned_ = 0.0;     // rotation of the last step of this tick
  double first_rotation_ = 0.0;  // of the first step of a tick
  int steps_ = 0, changes_ = 0, max_changes_ = kMaxChanges;  // of this tick
  std::uint64_t work_from_ = 0;

  // At pose_, where rows_known_:
  bool rows_known_ = false, metric_known_ = false;
  std::size_t row_count_ = 0;
  double room_ = 0.0;  // pairs without a row have at least this gap
  std::array<Six, SmallQp::kMaxRows> rows_;
  std::array<Vec3, SmallQp::kMaxRows> normals_, levers_;
  std::array<double, SmallQp::kMaxRows> gaps_, distances_, bounds_;
  Factor6 metric_;
  QpSolution solution_;
  double part_ = 1.0;  // share of the pull for which solution_ was found
  SmallQp qp_;
  BodyPathObserver* observer_ = nullptr;
};

}  // namespace moltact
