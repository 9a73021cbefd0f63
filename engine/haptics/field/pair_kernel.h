// The energies of one atom with blocks of eight others, with gradient and curvature: the inner loop of PairSum. Vectors of
// eight floats; a processor with AVX2 takes one instruction for each, others two or eight, with the same bits. Haptic
// thread. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <array>
#include <cmath>

#include "engine/haptics/field/pair_model.h"

namespace moltact {

/// Eight atoms, relative to a centre near them. An empty place has depth and charge 0.
struct alignas(32) PairBlock {
  static constexpr int kLanes = 8;
  float x[kLanes], y[kLanes], z[kLanes], charge_e[kLanes], half_minimum_A[kLanes], root_depth[kLanes];

  void set(int lane, const Vec3& relative, const PairAtom& atom) noexcept {
    x[lane] = float(relative.x);
    y[lane] = float(relative.y);
    z[lane] = float(relative.z);
    charge_e[lane] = atom.charge_e;
    half_minimum_A[lane] = atom.half_minimum_A;
    root_depth[lane] = std::sqrt(atom.depth_kcal_mol);
  }
  /// Empties the places from this one on. They are beyond every cut-off.
  void clear(int from_lane) noexcept {
    for (int lane = from_lane; lane < kLanes; ++lane) set(lane, Vec3(1e4), {});
  }
};

/// One atom, relative to the centre of the blocks.
struct PairOwn {
  float x = 0, y = 0, z = 0, charge_e = 0, half_minimum_A = 0, root_depth = 0;
};

/// Sums over pairs.
struct PairTerms {
  double van_der_waals = 0, electrostatic = 0;  // kcal/mol
  Vec3 gradient{0.0};                           // kcal/mol/A, of the own atom's position
  std::array<double, 6> curvature{};            // kcal/mol/A^2: xx, yy, zz, xy, xz, yz
};

/// A PairModel's numbers, as the loop needs them.
struct PairConstants {
  explicit PairConstants(const PairModel& model);
  float coulomb;                     // of charges in the model's dielectric
  float cut2, from2, inverse_width;  // squares of cut-off and start of the switch; 1 / (cut2 - from2)
};

using AddPairs = void (*)(const PairBlock* blocks, int count, const PairConstants& constants, const PairOwn& own,
                          PairTerms& terms) noexcept;

/// The gradient of each pair's energy, by the own atom's position (unit: kcal/mol/A).
using PairGradients = std::array<Vec3, PairBlock::kLanes>;
using EachPair = void (*)(const PairBlock& block, const PairConstants& constants, const PairOwn& own,
                          PairGradients& out) noexcept;

/// The loop without the curvature and with it, which takes about twice the time; and the pairs one by one.
struct PairKernel {
  AddPairs slope = nullptr, curvature = nullptr;
  EachPair each = nullptr;
};

/// The loops for this processor.
PairKernel pairKernel(Dielectric kind) noexcept;
/// The loops for every processor. They give the same bits.
PairKernel plainPairKernel(Dielectric kind) noexcept;

}  // namespace moltact
