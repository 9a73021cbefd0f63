// Writes atoms of a molecule at other places as the text of a PDB file (format 3.3): a ligand in a pose. Pure function,
// any thread. Unit: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// TITLE, the remarks as REMARK 1 (broken at words where a line would exceed 80 columns), the atoms in this order at
/// `places_A` (one for each) to 0.001 A, END. Atoms of amino acids and nucleotides are ATOM records, others HETATM. Names
/// that exceed their columns are cut; a chain's name is its first letter. What is not printable ASCII becomes '?'. A
/// Problem where a place does not fit into its columns: -999.999 to 9999.999 A.
Expected<std::string> posedPdb(const Molecule& molecule, std::span<const std::uint32_t> atoms,
                               std::span<const Vec3> places_A, const std::string& title,
                               std::span<const std::string> remarks);

}  // namespace moltact
