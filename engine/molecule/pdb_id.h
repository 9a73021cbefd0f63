// Identifiers of entries of the Protein Data Bank.
#pragma once

#include <string>

namespace moltact {

/// Normalizes an id to the archive's file names: "5ADH" from "5adh" or "pdb_00005adh". An extended id without short
/// form is kept ("pdb_1a2b3c4d"). Empty if `text` is not a PDB id (a digit and three letters or digits, or pdb_ and
/// eight).
std::string pdbId(const std::string& text);

}  // namespace moltact
