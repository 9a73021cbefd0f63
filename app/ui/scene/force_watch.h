// The forces between what the hand holds and the molecule, by parts, for the picture. These are the energies of
// residues, that of the held atom with the highest energy, hydrogen bonds and clashes. Computed from the pose of the
// newest tick, once per frame at most and less often for a large body. Window's thread. Units: angstrom, kcal/mol.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/scene/touchable_model.h"
#include "engine/haptics/field/pair_shares.h"
#include "engine/render/annotations.h"
#include "engine/render/atom_style.h"
#include "engine/servo/servo_step.h"
#include "engine/structure/hydrogen_bonds.h"

namespace moltact {

/// A pair of atoms that is not bonded by a hydrogen and has at least this Lennard-Jones energy is a clash.
inline constexpr double kClash_kcal_mol = 1.0;

/// A hydrogen bond or a clash between an atom of the held body and one of the molecule.
struct HeldLine {
  std::uint32_t held = 0, scene = 0;  ///< atoms of the molecule that is on the stage
  PointA from, to;                    ///< where they are
  bool clash = false;                 ///< else a hydrogen bond
};

class ForceWatch {
 public:
  /// The atoms of a new interaction's forces; null: none act, and nothing is computed.
  void begin(const TouchableModel& stage, std::shared_ptr<const PairField> pairs);
  /// Called once per frame with the newest tick. What the scene does not draw (`hidden`) is left out of residues and
  /// lines.
  void follow(const ServoSample& now, const AtomList& hidden);

  /// Whether the newest tick had forces between atoms.
  bool on() const { return on_; }
  /// By residue, that of the largest amount first; EnergyShare::index is the residue. Those below 0.05 kcal/mol are
  /// omitted.
  const std::vector<EnergyShare>& residues() const { return residues_; }
  /// The highest energy of a held atom, before the bound of the walls; none without forces.
  std::optional<double> highest_kcal_mol() const { return highest_; }
  /// The force between what is held and the molecule, without bound and gain; none without forces (unit: kcal/mol/A).
  std::optional<double> between_kcal_mol_A() const {
    return at_ ? std::optional(glm::length(shares_->force_kcal_mol_A())) : std::nullopt;
  }
  /// The atoms of the forces; null without them.
  const std::shared_ptr<const PairField>& field() const { return field_; }
  /// Of a body, hydrogen bonds before clashes; empty for a probe.
  const std::vector<HeldLine>& lines() const { return lines_; }
  /// The lines as dashes with their lengths; null: none. Another address means other lines.
  const std::shared_ptr<const Annotations>& drawnLines() const { return drawn_; }

 private:
  void clear();
  void findLines(const PoseA& pose);
  void drawLines();
  bool isDrawn(std::uint32_t atom) const;

  TouchableModel stage_;
  std::shared_ptr<const PairField> field_;
  std::optional<PairShares> shares_;
  std::optional<HeldHydrogenBonds> bonds_;
  bool on_ = false;
  std::optional<PoseA> at_;  // of the results
  std::size_t frames_left_ = 0;
  std::vector<EnergyShare> residues_;
  std::optional<double> highest_;
  std::vector<HeldLine> lines_;
  std::shared_ptr<const Annotations> drawn_;
  AtomList hidden_;
  std::string language_;  // of the lengths
};

}  // namespace moltact
