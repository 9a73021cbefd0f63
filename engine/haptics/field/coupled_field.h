// What the hand holds, in the field of the scene's atoms. A spring, the virtual coupling (Colgate, Stanley & Brown, IROS
// 1995), joins it to the hand, as the spring of a steered molecular dynamics simulation does. In each tick the
// held body moves towards a minimum of
//   k / 2 |x - x_hand|^2 + k L^2 / 2 |log(q_hand q^-1)|^2 + U(x, q)
// in free space. The hand feels the coupling alone, so the stiffness of the loop does not depend on the field, however
// steep it is. A body that falls into a well loses the energy that the fall sets free.
//
// A tick bounds U from above near the pose by a quadratic with U's gradient and an upper bound K of its curvature. The
// minimum of the coupling and that quadratic is the place to which the inner interaction is led; it keeps the contact. A tick
// that raised the energy is undone and K is enlarged. The field thus costs one sum over pairs per tick.
//
// Haptic thread; no allocation after construction. Units: angstrom, kcal/mol, radian.
#pragma once

#include <memory>
#include <vector>

#include "engine/haptics/field/pair_field.h"
#include "engine/haptics/field/pair_sum.h"
#include "engine/haptics/slip_coupling.h"
#include "engine/haptics/wrapped_interaction.h"

namespace moltact {

/// The spring between hand and body.
struct VirtualCoupling {
  double stiffness_kcal_mol_A2 = 50.0;  ///< k, above 0
  double lever_A = 0.0;                 ///< L; 0: a point, which is not turned
  double reach_A = 0.0;                 ///< the greatest distance of a body's atom from its middle
};

class CoupledField final : public WrappedInteraction {
 public:
  /// The greatest distance that any atom moves in a tick, inside the field and outside of it.
  static constexpr double kStep_A = 0.25, kFreeStep_A = PairSum::kMargin_A;

  CoupledField(std::unique_ptr<Interaction> inner, std::shared_ptr<const PairField> field,
               const VirtualCoupling& coupling);

  /// Force and torque are those of the coupling. Contact::scp is the body's middle, also without contact; atoms and
  /// normals are those of the inner interaction. Response::at_rest: the body moved by less than kRest_A.
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  /// The contacts' and the field's. While the body moves to the minimum they do not add up to the
  /// felt force; the remainder is shared in proportion.
  std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                        std::span<AtomForce> out) const noexcept override;
  std::size_t maxReactionCount() const noexcept override { return inner().maxReactionCount() + forces_.size(); }
  /// The field's atoms do not move.
  bool setMotion(const SphereMotion* motion) noexcept override { return motion == nullptr; }
  MemoryUsage memoryUsage() const noexcept override;

  static constexpr double kRest_A = 1e-3;

  const PairSum& sum() const noexcept { return sum_; }
  int rejected() const noexcept { return rejected_; }  ///< ticks that were undone, since the start
  /// The energy of coupling and field of a body in this pose, for the hand of the last call (unit: kcal/mol).
  double couplingEnergy_kcal_mol(const PoseA& body) const noexcept;

 private:
  Response begin(const PoseA& hand) noexcept;
  Response step(const PoseA& hand) noexcept;
  Response felt(const PoseA& hand, const Response& inner) noexcept;
  PoseA goal() const noexcept;

  std::shared_ptr<const PairField> field_;
  PairSum sum_;
  VirtualCoupling coupling_;
  SlipCoupling turning_;
  bool placed_ = false;
  PoseA hand_, body_;  // hand_: its orientation after the slip
  PairEnergy at_;      // at body_
  double caution_ = 1.0;
  double moved_A_ = 0.0;
  bool limited_ = false;
  int rejected_ = 0;
  Response inner_answer_;
  PoseA goal_;
  // For reactions.
  mutable std::vector<Vec3> forces_;
  mutable std::vector<std::uint32_t> near_;
};

}  // namespace moltact
