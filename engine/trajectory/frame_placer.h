// Puts the atoms of a molecule where a frame of a trajectory has them. Selects them among the atoms of the frame, and
// makes molecules whole that the periodic cell cuts. Superposes the frame on the molecule, so that it does not drift
// away. The result depends on the frame alone, not on those before it. Immutable; any thread except the haptic one.
// Unit: angstrom.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/trajectory/trajectory_file.h"

namespace moltact {

/// How frames are superposed.
struct FrameFit {
  bool superposed = true;
  std::vector<std::uint32_t> on;  ///< over these atoms, ascending, selected as by superpose(); empty: over all
  friend bool operator==(const FrameFit&, const FrameFit&) = default;
};

class FramePlacer {
 public:
  /// `atoms`: of the trajectory, which has either the atoms of the molecule's file (water and alternates included) or
  /// those of the molecule. `file` is its name in problems.
  static Expected<FramePlacer> make(std::shared_ptr<const Molecule> molecule, std::size_t atoms,
                                    const std::string& file, const FrameFit& fit);

  /// The positions of the molecule's atoms.
  std::vector<Vec3> place(const TrajectoryFrame& frame) const;

  const Molecule& molecule() const { return *molecule_; }
  /// The covalent molecule of each atom, and the number of these.
  std::span<const std::uint32_t> partOf() const { return part_of_; }
  std::size_t parts() const { return parts_; }

 private:
  FramePlacer() = default;
  void makeWhole(std::vector<Vec3>& places, const glm::dmat3& cell) const;

  std::shared_ptr<const Molecule> molecule_;
  bool superposed_ = false;
  // The atoms that superpose() takes: the chosen ones, and those of the largest covalent molecule.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> fitted_, turns_;
  struct Step {
    std::uint32_t atom = 0, from = 0;  // bonded; `from` comes first
  };
  std::vector<Step> steps_;             // along the bonds of each covalent molecule
  std::vector<std::uint32_t> part_of_;  // the covalent molecule of each atom
  std::size_t parts_ = 0, largest_ = 0;
};

}  // namespace moltact
