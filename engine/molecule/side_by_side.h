// Two molecules beside each other for comparison, as one molecule: the second stands at the right of the first (+x), with
// a gap between them in which a hand has room. Not for the haptic thread. Units: angstrom.
#pragma once

#include <filesystem>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// Between the outsides of the two.
inline constexpr double kBesideGap_A = 10.0;

/// What the name of a chain of the second molecule ends in: its chain A is "A2".
inline constexpr const char* kBesideEnding = "2";

/// The atoms of both, the second's behind the first's. Where three or more residues are the same by chain, number and name, and
/// most of those that both have, the second is turned as the first is (least squares over CA and P), else it stands as
/// its file has it; its middle is at the first's height and depth.
Molecule sideBySide(Molecule first, Molecule second);

/// How the molecule beside is read: as the first is, but in its first model and as its coordinates stand.
ReadOptions besideReading(ReadOptions first);

/// Reads a molecule and the one that `reading.beside` names, which is looked for beside its file, in the library and among
/// what was fetched.
Expected<Molecule> readSideBySide(const std::filesystem::path& file, const ReadOptions& reading);

}  // namespace moltact
