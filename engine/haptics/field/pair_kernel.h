// The energies of one atom with blocks of eight others, with gradient and curvature: the inner loop of PairSum. Vectors of
// eight floats; a processor with AVX2 needs one instruction per vector, others two or eight; the results are bit-identical. Haptic
// thread. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <array>
#include <cmath>

#include "engine/haptics/field/energy_part.h"
#include "engine/haptics/field/pair_model.h"

namespace moltact {

/// Eight atoms, relative to a centre near them. An empty place has depth and charge 0.
struct alignas(32) PairBlock {
  static constexpr int kLanes = 8;
  float x[kLanes], y[kLanes], z[kLanes], charge_e[kLanes], half_minimum_A[kLanes], root_depth[kLanes];
  /// Bounds of the atoms' distances from the centre. The loops skip what cannot be within the cut-off, and the switch where
  /// no atom can reach it; the result does not change. The defaults hold for any atoms.
  float nearest_A = 0.0f, farthest_A = 1e30f;

  void set(int lane, const Vec3& relative, const PairAtom& atom) noexcept {
    set(lane, relative, atom, std::sqrt(atom.depth_kcal_mol));
  }
  /// The same with the square root of the atom's depth.
  void set(int lane, const glm::vec3& relative, const PairAtom& atom, float root) noexcept {
    x[lane] = relative.x;
    y[lane] = relative.y;
    z[lane] = relative.z;
    charge_e[lane] = atom.charge_e;
    half_minimum_A[lane] = atom.half_minimum_A;
    root_depth[lane] = root;
  }
  /// Clears the lanes from this one on by moving them beyond every cut-off.
  void clear(int from_lane) noexcept {
    for (int lane = from_lane; lane < kLanes; ++lane) set(lane, Vec3(1e4), {});
  }
};

/// One atom, relative to the centre of the blocks. The constructor copies all parameters of the atom, as PairBlock does.
struct PairOwn {
  float x = 0, y = 0, z = 0, charge_e = 0, half_minimum_A = 0, root_depth = 0;

  PairOwn() = default;
  PairOwn(const PairAtom& atom, const Vec3& relative_A)
      : x(float(relative_A.x)),
        y(float(relative_A.y)),
        z(float(relative_A.z)),
        charge_e(atom.charge_e),
        half_minimum_A(atom.half_minimum_A),
        root_depth(std::sqrt(atom.depth_kcal_mol)) {}
};

/// Sums over pairs.
struct PairTerms {
  EnergyByPart energy;
  Vec3 gradient{0.0};                 // kcal/mol/A, with respect to the own atom's position
  std::array<double, 6> curvature{};  // kcal/mol/A^2: xx, yy, zz, xy, xz, yz
};

/// Blocks that lie one after the other.
struct PairRun {
  const PairBlock* blocks;
  int count;
};

/// A PairModel's numbers, as the loop needs them.
struct PairConstants {
  explicit PairConstants(const PairModel& model);
  float coulomb;                     // of charges in the model's dielectric
  float cut_A, from_A;               // cut-off and start of the switch
  float cut2, from2, inverse_width;  // their squares; 1 / (cut2 - from2)
};

/// The sums over the pairs of all runs, of `count` runs.
using AddPairs = void (*)(const PairRun* runs, int count, const PairConstants& constants, const PairOwn& own,
                          PairTerms& terms) noexcept;

/// The gradient of each pair's energy with respect to the own atom's position (unit: kcal/mol/A).
using PairGradients = std::array<Vec3, PairBlock::kLanes>;
using EachPair = void (*)(const PairBlock& block, const PairConstants& constants, const PairOwn& own,
                          PairGradients& out) noexcept;

/// Three loops: without curvature, with it (about twice the time), and pair by pair.
struct PairKernel {
  AddPairs slope = nullptr, curvature = nullptr;
  EachPair each = nullptr;
};

/// The loops for this processor.
PairKernel pairKernel(Dielectric kind) noexcept;
/// Portable loops; the results are bit-identical.
PairKernel plainPairKernel(Dielectric kind) noexcept;

}  // namespace moltact
