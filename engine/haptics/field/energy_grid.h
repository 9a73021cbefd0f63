// The energy of a held body with a scene, interpolated from precomputed maps: an alternative to the direct sum
// (pair_sum.h).
// One map for each size of the body's atoms holds their Lennard-Jones energy, one more the electrostatic potential. The time
// of a call does not depend on the scene. The error depends on the spacing; `body_benchmark` measures it.
//
// Grids can be nested: a fine one round a site inside a coarse one. Over the outermost kGridBlend_A of the fine one
// the energy passes smoothly to the coarse one, so that energy and (tricubic) force stay continuous.
//
// Haptic thread; no allocation after construction. The maps are shared and immutable. Units: angstrom, kcal/mol,
// elementary charge.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/haptics/field/grid_map.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/haptics/field/pair_sum.h"

namespace moltact {

inline constexpr double kGridBlend_A = 1.0;

/// Maps on the nodes of one box.
struct GridMaps {
  GridBox box;
  std::vector<std::vector<float>>
      van_der_waals;  ///< of a probe with depth 1 (AutoGrid's maps: with the depth of their type), each of box.count()
  std::vector<float> electrostatic;  ///< of a charge of 1 e; empty: none
  std::vector<float> desolvation;    ///< multiplied by the absolute charge, as in AutoDock; empty: none
  /// Above zero, van der Waals energies are stored as f asinh(E / f), so that walls of 1e10 kcal/mol do not spoil the
  /// interpolation beside them. The interpolated value is converted back. 0: stored unchanged,
  /// as is customary.
  double fold = 0.0;

  std::size_t bytes() const;
};

/// Converts the maps of van der Waals energies from unfolded to folded with `fold` > 0.
void foldWalls(GridMaps& maps, double fold);

/// An atom of the body; its centre is relative to the body's middle.
struct GridAtom {
  Vec3 centre_A{0.0};
  std::int32_t map = -1;  ///< index in GridMaps::van_der_waals; -1: no such energy
  float factor = 1.0f;    ///< of that map
  float charge_e = 0.0f;
};

/// The distinct half_minimum_A of the atoms that have a depth, ascending: one map each.
std::vector<float> gridSizes(std::span<const PairAtom> body);
/// The atoms for maps of these sizes. An atom whose size is not among them has no van der Waals energy.
std::vector<GridAtom> gridAtoms(std::span<const PairAtom> body, std::span<const float> sizes);

class EnergyGrid {
 public:
  /// Both levels must have the same kinds and number of maps, each of its box's count; `fine` may be empty. Only the
  /// part of the fine box inside the coarse one is used.
  EnergyGrid(std::shared_ptr<const GridMaps> coarse, std::shared_ptr<const GridMaps> fine, std::vector<GridAtom> body,
             GridInterpolation interpolation, double wall_kcal_mol);

  /// The energy of the body in this pose of its middle, with the meaning of PairSum::at. Zero for a pose that is not finite
  /// and where an atom is outside of the coarse box. The curvature is that of the tricubic interpolation; trilinear forces
  /// jump at faces by about the curvature times the spacing.
  PairEnergy at(const PoseA& pose) noexcept;

  /// True where an atom was outside of the box in the last call.
  bool outside() const noexcept { return outside_; }

 private:
  PairTerms terms(const GridMaps& maps, const GridCell& cell, const GridAtom& atom, bool curved) const noexcept;
  void blendFine(PairTerms& coarse, const Vec3& place, const GridAtom& atom, bool curved) const noexcept;

  std::shared_ptr<const GridMaps> coarse_, fine_;
  std::vector<GridAtom> body_;
  GridInterpolation interpolation_;
  double wall_;
  std::vector<std::array<double, 6>> curvatures_;  // of body_
  std::uint64_t calls_ = 0;
  bool outside_ = false;
};

}  // namespace moltact
