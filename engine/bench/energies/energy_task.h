// The held bodies, scenes and paths on which methods for energies between atoms are compared. Units: angstrom, kcal/mol,
// elementary charge.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bench/bodies/body_tasks.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact::bench {

struct EnergyTask {
  std::string name;
  std::shared_ptr<const SphereGrid> scene;  ///< the centres of `atoms`
  std::vector<PairAtom> atoms, held;        ///< `held` relative to its middle
  Vec3 home_A{0.0};                         ///< of the middle: where the structure has it
  double gyration_A = 0.0;
};

/// The walls of measured grids are folded with this (foldWalls).
inline constexpr double kGridWall_kcal_mol = 4.0;

inline constexpr std::array<std::string_view, 3> kEnergyTasks{"ligand", "200", "chain"};

/// "ligand": amprenavir in 1HPV; "200": the 200 atoms of chain A of 2HHB nearest to chain B, against B; "chain": all of
/// A's protein against B's. Parameters are those of pairAtoms(). Returns the Problem of a molecule that cannot be
/// opened.
Expected<EnergyTask> energyTask(std::string_view name, const OpenMolecule& open);

/// Poses of the middle: to and fro by up to 0.5 A along each axis and by as much in turning, at the gyration radius.
std::vector<PoseA> energyPath(const EnergyTask& task, int ticks);

}  // namespace moltact::bench
