// The force on the hand as a physical quantity, independent of its source. Units: newtons at the hand and angstroms in
// the molecule, in the molecule's axes. `inDevice` is the only conversion to a device's millimetres. Plain data, every
// thread.
#pragma once

#include <cstdint>

#include "engine/core/units.h"
#include "engine/haptics/field/energy_part.h"

namespace moltact {

/// Force and torque with their potential energy and stiffness. Force is the negative gradient of energy in either
/// space: an energy in N A, divided by the scale (A/mm), is an energy in N mm.
struct FeltForce {
  Vec3 force_N{0.0};
  Vec3 torque_N_A{0.0};     ///< about the pose's position
  double energy_N_A = 0.0;  ///< potential energy; zero where nothing acts, negative in a well
  /// Upper bound of the resisting force per displacement: the largest curvature of the energy in any direction, at
  /// least 0.
  double stiffness_N_per_A = 0.0;
  /// The same for torque per rotation (per radian).
  double rotational_stiffness_N_A = 0.0;

  friend bool operator==(const FeltForce&, const FeltForce&) = default;
};

/// The energy of a held body or probe with the scene, as parts and as felt (unit: kcal/mol).
struct MolecularEnergy {
  EnergyByPart parts;
  double felt_kcal_mol = 0.0;  ///< their sum after the bound of the walls (PairModel::wall_kcal_mol)
  /// Stiffness of the spring between the hand and what it holds, in the molecule (unit: kcal/mol/A^2). Under
  /// 1 kcal/mol/A it extends by 1 / this (A); the hand feels that extension times the stiffness of the felt spring (N). 0:
  /// there is no such spring.
  double coupling_kcal_mol_A2 = 0.0;

  double total_kcal_mol() const { return parts.total_kcal_mol(); }

  friend bool operator==(const MolecularEnergy&, const MolecularEnergy&) = default;
};

/// The force on one atom of the scene, in the molecule's axes: the reaction to the force on the hand. It is in newtons
/// of the hand, not in those between molecules.
struct AtomForce {
  std::int32_t atom = -1;
  Vec3 force_N{0.0};
  std::int32_t body_sphere = -1;  ///< index of the held body's sphere that the atom stops; -1: no body is held
};

/// A FeltForce in the device's space: newton and millimetre, in the device's axes.
struct DeviceForce {
  Vec3 force_N{0.0};
  Vec3 torque_N_mm{0.0};
  double energy_N_mm = 0.0;
  double stiffness_N_per_mm = 0.0;
  double rotational_stiffness_N_mm = 0.0;
};

inline DeviceForce inDevice(const FeltForce& felt, const Workspace& workspace) {
  const double A_per_mm = workspace.A_per_mm;
  return {.force_N = glm::transpose(workspace.rotation) * felt.force_N,
          .torque_N_mm = glm::transpose(workspace.rotation) * felt.torque_N_A / A_per_mm,
          .energy_N_mm = felt.energy_N_A / A_per_mm,
          .stiffness_N_per_mm = felt.stiffness_N_per_A * A_per_mm,
          .rotational_stiffness_N_mm = felt.rotational_stiffness_N_A / A_per_mm};
}

}  // namespace moltact
