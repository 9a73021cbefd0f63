// Minimises the felt energy of a rigid body in a field of atoms (pair_sum.h) from a pose, one sum over the pairs in each
// step. The method of Broyden, Fletcher, Goldfarb and Shanno in six dimensions, with steps limited to what an atom may
// move (Nocedal & Wright, Numerical Optimization, 2006, chapter 6). No allocation after construction: a few steps fit
// beside each tick, or in a frame of the window. Units: angstrom, kcal/mol, radian.
#pragma once

#include <array>

#include "engine/haptics/field/pair_sum.h"

namespace moltact {

class PoseMinimiser {
 public:
  /// No atom at the radius of gyration moves by more than this in a step.
  static constexpr double kMaxStep_A = 0.2;
  /// Converged where force, and torque divided by the radius of gyration, are below this.
  static constexpr double kForceDone_kcal_mol_A = 0.002;
  /// Or where no way down is longer than this, which float's rounding sets.
  static constexpr double kStepDone_A = 1e-6;

  /// `sum` must outlive the minimiser; `gyration_A` is the radius of gyration of its body (radiusOfGyration_A()).
  PoseMinimiser(PairSum& sum, double gyration_A) noexcept;

  /// Starts from a pose; converged at once if its energy is not finite.
  void start(const PoseA& pose) noexcept;
  /// One trial pose. It is kept if the energy falls. Returns false once converged.
  bool step() noexcept;

  const PoseA& pose() const noexcept { return pose_; }           ///< the lowest so far
  const PairEnergy& energy() const noexcept { return energy_; }  ///< at pose()
  bool converged() const noexcept { return converged_; }
  int steps() const noexcept { return steps_; }  ///< since start()

 private:
  using Six = std::array<double, 6>;  // translation, and rotation times the radius of gyration

  Six gradient(const PairEnergy& energy) const noexcept;
  PoseA moved(const Six& way, double length) const noexcept;
  void forget() noexcept;
  void choose() noexcept;
  void learn(const Six& way, const Six& change) noexcept;

  PairSum& sum_;
  double gyration_A_;
  PoseA pose_;
  PairEnergy energy_;
  Six gradient_{}, way_{};
  std::array<Six, 6> inverse_{};  // of the curvature
  double length_ = 1.0;           // share of way_ in the next trial
  bool converged_ = true, fresh_ = true;
  int steps_ = 0;
};

/// The root mean square distance of the atoms from the body's middle, at least 1 A.
double radiusOfGyration_A(std::span<const PairAtom> body) noexcept;

}  // namespace moltact
