// Tables of van der Waals radii by element. The reading option `radii` (molecule_key.h) selects one; a radius in the
// molecule's file takes precedence. Plain data, any thread. Units: angstrom.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "engine/core/offered_word.h"
#include "engine/molecule/elements.h"

namespace moltact {

/// Radius of elements for which a table has none: Bondi's carbon.
inline constexpr double kDefaultRadius_A = 1.70;

struct RadiusTable {
  /// The name in scenes, options and files, its title and its source.
  OfferedWord word;
  /// By atomic number; 0: none is published. Index 0 is the unknown element.
  std::array<double, kElementCount + 1> radius_A{};
  /// By how much the atoms of a held body are reduced (held_body.h), so that a ligand fits into its site: with these
  /// radii amprenavir in 1HPV overlaps by up to `ligand_overlap_A`, which must be less.
  double body_overlap_A = 0.0, ligand_overlap_A = 0.0;

  /// True if the table has a radius for this atomic number.
  bool knows(int atomic_number) const;
  /// That radius, else kDefaultRadius_A.
  double radius(int atomic_number) const;
};

/// All tables; the first is the default.
std::span<const RadiusTable> radiusTables();
/// The table of this name; the default for an unknown one.
const RadiusTable& radiusTable(std::string_view name);

}  // namespace moltact
