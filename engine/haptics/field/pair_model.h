// The energy between two atoms that do not touch: Lennard-Jones and Coulomb, switched off smoothly at a cut-off. The
// parameters are those of AMBER's force fields. Plain data, every thread. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/core/units.h"

namespace moltact {

/// Energy of two elementary charges 1 A apart in vacuum (unit: kcal/mol A), as in AMBER.
inline constexpr double kCoulomb_kcal_A = 332.0637;
/// The force of 1 kcal/mol/A (unit: piconewton). The stiffness of 1 kcal/mol/A^2 is 1e-5 N/mm times this number.
inline constexpr double kForceUnit_pN = 69.47695;

/// The parameters of one atom. Two atoms have the minimum of their Lennard-Jones energy at the sum of their
/// half-distances (rmin/2), with the geometric mean of their depths (Lorentz–Berthelot rules).
struct PairAtom {
  Vec3 centre_A{0.0};
  float half_minimum_A = 0.0f;  ///< half of the distance at which two such atoms have their lowest energy (rmin / 2)
  float depth_kcal_mol = 0.0f;  ///< of that minimum; 0: no Lennard-Jones energy
  float charge_e = 0.0f;
};

/// The solvent between charges, as a dielectric that scales their energy down.
enum class Dielectric : std::uint8_t {
  Constant,       ///< PairModel::dielectric at every distance
  Distance,       ///< PairModel::dielectric times the distance in angstrom
  MehlerSolmajer  ///< sigmoidal, 1 at contact to 78 in water (Mehler & Solmajer, Protein Eng. 4, 903, 1991), as in AutoDock
};

struct PairModel {
  Dielectric kind = Dielectric::MehlerSolmajer;
  double dielectric = 4.0;
  double cutoff_A = 10.0;      ///< the energy is zero from here
  double switch_from_A = 8.0;  ///< and unchanged up to here; in between, energy and force are continuous
  /// The felt energy of each held atom is E below zero and E0 asinh(E / E0) above: walls are bounded, wells unchanged.
  /// Infinity: E everywhere.
  double wall_kcal_mol = 1.0;
  /// How many times as strong the weakest forces of a held atom are felt (1 or more): see FeltFunction.
  double weak_gain = 1.0;

  friend bool operator==(const PairModel&, const PairModel&) = default;
};

/// The felt energy of a held atom, by its energy, and its derivatives. It rises everywhere.
struct FeltEnergy {
  double value, slope, curvature;
};

/// The function from an atom's energy E to the felt one. Above zero, E0 asinh(g E / E0) with E0 = `wall_kcal_mol`. Below
/// zero, E for g = 1, else E1 asinh(g E / E1), with E1 such that kEvenWell_kcal_mol is felt as it is. At zero both have the
/// slope g and no curvature, so the felt force is continuous, and it remains that of a potential, whatever g is. An E0 of
/// infinity leaves every energy as it is.
class FeltFunction {
 public:
  /// The depth of an atom's well that no gain changes (unit: kcal/mol).
  static constexpr double kEvenWell_kcal_mol = 5.0;

  explicit FeltFunction(double wall_kcal_mol, double weak_gain = 1.0) noexcept
      : wall_(wall_kcal_mol), gain_(std::isfinite(wall_kcal_mol) && weak_gain > 1.0 ? weak_gain : 1.0) {
    if (gain_ == 1.0) return;
    // E1 asinh(5 g / E1) rises with E1 from 0 to 5 g.
    double low = 1e-6, high = 1e6;
    for (int k = 0; k < 100; ++k) {
      well_ = std::sqrt(low * high);
      (well_ * std::asinh(gain_ * kEvenWell_kcal_mol / well_) < kEvenWell_kcal_mol ? low : high) = well_;
    }
  }
  explicit FeltFunction(const PairModel& model) noexcept : FeltFunction(model.wall_kcal_mol, model.weak_gain) {}

  FeltEnergy at(double energy_kcal_mol) const noexcept {
    const bool wall = energy_kcal_mol > 0.0;
    if (!std::isfinite(wall_) || (!wall && gain_ == 1.0)) return {energy_kcal_mol, 1.0, 0.0};
    const double scale = wall ? wall_ : well_, x = gain_ * energy_kcal_mol / scale, fall = 1.0 / std::sqrt(1.0 + x * x);
    return {scale * std::asinh(x), gain_ * fall, -gain_ * gain_ * x / scale * fall * fall * fall};
  }

 private:
  double wall_, gain_, well_ = 1.0;
};

inline FeltEnergy feltEnergy(double energy_kcal_mol, double wall_kcal_mol) noexcept {
  return FeltFunction(wall_kcal_mol).at(energy_kcal_mol);
}

/// Below this distance the energy of a pair continues as a parabola, so that two atoms in one place have a finite energy.
inline constexpr double kMinPair_A = 0.5;

}  // namespace moltact
