// An anisotropic elastic network (Atilgan et al., Biophys. J. 80, 505, 2001): one node per residue, equal springs
// between nodes nearer than a cut-off, at rest in the structure of the file. Built on request; immutable afterwards, so
// every thread may read it. Units: angstrom; the springs have stiffness 1; functions of
// normal_modes.h scale it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"
#include "engine/molecule/molecule.h"

namespace moltact {

class ElasticNetwork {
 public:
  static constexpr double kCutOff_A = 15.0;
  static constexpr double kMinCutOff_A = 6.0, kMaxCutOff_A = 40.0;
  /// Limits of the number of nodes. Fewer than four have no mode of deformation; more take longer than 20 s.
  static constexpr std::size_t kMinNodes = 4, kMaxNodes = 2000;

  /// The nodes are CA of amino acids, P (at a 5' end O5') of nucleotides and, of any other residue but water, the heavy
  /// atom nearest to its centre. Returns a Problem for a molecule with too few or too many nodes, one whose
  /// parts no spring connects, and a cut-off out of range.
  /// `left_out` (ascending) are atoms that do not take part, such as those of a body in the hand: their residues have no
  /// nodes, and they do not move.
  static Expected<ElasticNetwork> make(const Molecule& molecule, double cut_off_A = kCutOff_A,
                                       std::span<const std::uint32_t> left_out = {});
  static constexpr std::uint32_t kNoNode = 0xFFFFFFFFu;

  /// The atom of each node, ascending.
  std::span<const std::uint32_t> nodes() const { return nodes_; }
  /// The node that an atom follows: that of its residue, else the nearest one; kNoNode if it was left out. `atom` must be
  /// in range.
  std::uint32_t nodeOf(std::size_t atom) const { return node_of_[atom]; }
  std::size_t atomCount() const { return node_of_.size(); }
  /// The position of a node at rest.
  const Vec3& place_A(std::size_t node) const { return places_[node]; }
  /// The springs: pairs of nodes, first < second.
  std::span<const std::pair<std::uint32_t, std::uint32_t>> springs() const { return springs_; }

 private:
  std::vector<std::uint32_t> nodes_, node_of_;
  std::vector<Vec3> places_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> springs_;
};

}  // namespace moltact
