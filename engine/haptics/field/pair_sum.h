// The direct sum of a held body's energy with a scene: each atom of the body with each atom of the scene within the
// cut-off. Each body atom has a list of the scene's atoms within the cut-off plus a margin. A list is valid while its atom
// has moved by less than the margin; most are renewed before that, a few in each tick. The result does not depend on the
// lists beyond the rounding of its sums. An atom for which no memory is left visits the grid in every tick instead.
//
// Haptic thread; no allocation after construction. Sums in float over eight lanes, the same on every processor
// (pair_kernel.h). Units: angstrom, kcal/mol, radian.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/felt_force.h"
#include "engine/haptics/field/pair_kernel.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

/// Energy, force and torque on the body, and their curvature.
struct PairEnergy {
  MolecularEnergy energy;
  Vec3 force_kcal_mol_A{0.0};  ///< the negative gradient of the felt energy
  Vec3 torque_kcal_mol{0.0};   ///< about the body's middle
  /// Upper bounds of the felt energy's curvature along any translation and about any axis, at least 0. Each body
  /// atom contributes its curvature from one of the last kCurvatureTicks calls.
  double stiffness_kcal_mol_A2 = 0.0, rotational_stiffness_kcal_mol = 0.0;
};

class PairSum {
 public:
  static constexpr double kMargin_A = 1.0;
  static constexpr double kRenewFrom_A = 0.75;  ///< a list is renewed in turn where its atom has moved farther
  static constexpr int kCurvatureTicks = 8;
  /// The largest number of pairs in lists; 32 bytes each.
  static constexpr std::size_t kMaxListedPairs = 1 << 21;

  /// `atoms` has one entry for each sphere of `scene`, whose centres are used. Untouchable spheres do not contribute. The
  /// centres of `body` are relative to its middle. Spheres that the scene merges as duplicates count once.
  PairSum(std::shared_ptr<const SphereGrid> scene, std::vector<PairAtom> atoms, std::vector<PairAtom> body,
          const PairModel& model);

  /// The energy of the body in this pose of its middle; zero for a pose that is not finite.
  PairEnergy at(const PoseA& pose) noexcept;

  /// The forces of the felt energy on the scene's atoms at the last pose (unit: kcal/mol/A). Their sum is the opposite
  /// of the force on the body, to the rounding of float. Both spans have one entry per atom. Writes the indices of
  /// atoms within the cut-off plus the margin to `near`, their forces to `forces` by index, and returns their number.
  std::size_t sceneForces(std::span<Vec3> forces, std::span<std::uint32_t> near) const noexcept;

  const PairModel& model() const noexcept { return model_; }
  std::size_t bodyAtoms() const noexcept { return body_.size(); }
  std::size_t sceneAtoms() const noexcept { return atoms_.size(); }
  std::size_t listedPairs() const noexcept { return listed_pairs_; }
  int renewedLists() const noexcept { return renewed_; }  ///< in the last call
  std::size_t bytes() const noexcept;

 private:
  static constexpr std::size_t kMaxCandidates = 4096;
  struct Chunk {
    static constexpr int kBlocks = 8, kAtoms = kBlocks * PairBlock::kLanes;
    std::array<PairBlock, kBlocks> blocks;
    std::array<std::uint32_t, kAtoms> atoms;  // indices in the scene
    std::int32_t next = -1;
  };
  struct List {
    Vec3 centre_A{0.0};
    std::int32_t first = -1, last = -1;  // chunks
    std::int32_t atoms = 0;
    bool valid = false, whole = true;  // not whole: no memory was left
  };

  /// An atom of the scene for a list. Longer lists are sorted in parts.
  struct Candidate {
    glm::vec3 relative_A;
    float squared_A2;
    std::uint32_t atom;
  };

  void renew(List& list, const Vec3& centre) noexcept;
  bool append(List& list, std::size_t count) noexcept;
  void release(List& list) noexcept;
  PairOwn own(std::size_t atom) const noexcept;
  template <class Visit>
  void eachPairOf(std::size_t atom, Visit&& visit) const noexcept;
  PairTerms sum(std::size_t atom, AddPairs add) const noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  std::vector<PairAtom> atoms_, body_;
  std::vector<float> root_depths_;  // of atoms_
  PairModel model_;
  FeltFunction felt_;
  PairConstants constants_;
  PairKernel kernel_;
  std::vector<List> lists_;
  std::vector<Vec3> places_;
  std::vector<Chunk> chunks_;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> order_;  // of candidates_, near to far
  std::int32_t free_ = -1;
  std::vector<std::array<double, 6>> curvatures_;  // of body_
  std::vector<double> slopes_;                     // of the bound of each body atom's energy, at the last pose
  std::uint64_t calls_ = 0;
  std::size_t cursor_ = 0, listed_pairs_ = 0;
  int renewed_ = 0;
};

}  // namespace moltact
