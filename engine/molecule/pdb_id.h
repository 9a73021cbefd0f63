// The names of entries of the Protein Data Bank.
#pragma once

#include <string>

namespace moltact {

/// The id as the archive's files are named: "5ADH" from "5adh" or from "pdb_00005adh"; an extended id without
/// a short form stays ("pdb_1a2b3c4d"). Empty where `text` is no PDB id (a digit and three letters or digits,
/// or pdb_ and eight).
std::string pdbId(const std::string& text);

}  // namespace moltact
