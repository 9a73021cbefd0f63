// The energy between a held body and a scene, by parts: of each held atom, and of each group of the scene's atoms (a
// residue). Also the pairs of atoms that are too near each other. For the picture; PairSum computes what is felt, with
// the same loop over pairs. One object on one thread at a time; not the haptic one. Units: angstrom, kcal/mol.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/haptics/field/pair_field.h"
#include "engine/haptics/field/pair_kernel.h"

namespace moltact {

/// The energy of all pairs of one held atom, or of one group, without the bound of the walls.
struct EnergyShare {
  std::uint32_t index = 0;  ///< of the held atom (PairField::held), or of the group
  EnergyByPart parts;

  double total_kcal_mol() const { return parts.total_kcal_mol(); }
  friend bool operator==(const EnergyShare&, const EnergyShare&) = default;
};

/// A pair of atoms that repel each other.
struct NearPair {
  std::uint32_t held = 0, scene = 0;    ///< indices in PairField::held and PairField::atoms
  double van_der_waals_kcal_mol = 0.0;  ///< of this pair
};

class PairShares {
 public:
  /// `group_of_carrier`: the group of each sphere of the scene (PairField::carriers), any numbers.
  PairShares(std::shared_ptr<const PairField> field, std::span<const std::uint32_t> group_of_carrier);

  /// Computes the shares of the body in this pose; all are zero for a pose that is not finite.
  void at(const PoseA& pose);
  /// Of every held atom, in order.
  std::span<const EnergyShare> held() const { return held_; }
  /// Of every group that has a pair within the cut-off, in the order of the groups' numbers.
  std::span<const EnergyShare> groups() const { return near_; }
  /// The force of the scene on the held atoms in this pose, of all pairs, without the bound of the walls or a gain.
  Vec3 force_kcal_mol_A() const { return force_; }
  /// The pairs of this pose with at least this Lennard-Jones energy (above 0).
  std::vector<NearPair> pairsAbove(double van_der_waals_kcal_mol) const;
  /// The centre of a held atom in the pose.
  Vec3 heldCentre_A(std::size_t atom) const { return places_[atom]; }

  std::size_t pairs() const { return pairs_; }  ///< summed in the last call of at()
  const PairField& field() const { return *field_; }

 private:
  struct Group {
    std::uint32_t number = 0;
    Vec3 centre_A{0.0};
    double radius_A = 0.0;
    std::size_t first_block = 0;
    int blocks = 0, atoms = 0;
  };

  std::shared_ptr<const PairField> field_;
  PairConstants constants_;
  PairKernel kernel_;
  std::vector<Group> groups_;
  std::vector<PairBlock> blocks_;
  double reach_A_ = 0.0;  // of the body
  std::vector<Vec3> places_;
  std::vector<EnergyShare> held_, near_;
  std::size_t pairs_ = 0;
  Vec3 force_{0.0};
};

}  // namespace moltact
