// Writes atoms of a molecule at other places as the text of an SD file with one molecule: a ligand in a pose. The format
// is that of BIOVIA's "CTfile Formats": V2000, or V3000 where V2000 cannot hold the molecule. Pure function, any thread.
// Units: angstrom, elementary charge.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// A data item of an SD file: "> <name>", the value on the next line, an empty line.
struct SdfItem {
  std::string name;   ///< letters, digits and underscores, the first a letter
  std::string value;  ///< one line of at most 200 characters; a longer one is cut
};

/// The atoms of one SD record. All arrays have one entry for each atom of the record.
struct SdfAtoms {
  std::span<const std::uint32_t> atoms;             ///< indices into the molecule
  std::span<const Vec3> places_A;                   ///< to be written, to 0.0001 A
  std::span<const std::int8_t> formal_charges_e{};  ///< empty: none but 0
};

/// The most atoms and the most bonds of a V2000 molecule.
inline constexpr std::size_t kMaxV2000 = 999;

/// `title` becomes the first line, `comment` the third, cut to 80 columns. `bonds` are of the whole molecule; those with both ends
/// among the atoms are written, of unknown order as type 8, "any". V3000 is taken for more than 999 atoms or bonds and
/// for a coordination bond, which V2000 lacks. An atom of unknown element is "*". What is not printable ASCII becomes
/// '?'. A Problem where a place does not fit into the columns of V2000: -9999.9999 to 99999.9999 A.
Expected<std::string> posedSdf(const Molecule& molecule, const SdfAtoms& what, std::span<const Bond> bonds,
                               const std::string& title, const std::string& comment, std::span<const SdfItem> items);

}  // namespace moltact
