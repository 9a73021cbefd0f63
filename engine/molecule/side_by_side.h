// Two molecules side by side for comparison, combined into one molecule. The second lies to the right of the first
// (+x), with a gap for the hand. Not for the haptic thread. Units: angstrom.
#pragma once

#include <filesystem>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// The gap between the surfaces of the two.
inline constexpr double kBesideGap_A = 10.0;

/// The suffix of chain names of the second molecule: its chain A becomes "A2".
inline constexpr const char* kBesideEnding = "2";

/// Combines two molecules; the second's atoms follow the first's. The second is superimposed on the orientation of the
/// first by least squares over CA and P. This requires at least three residues, and most of those present in both, that
/// agree in chain, number and name. Otherwise it keeps its file's orientation. Its middle has the first's height and
/// depth.
Molecule sideBySide(Molecule first, Molecule second);

/// The reading options of the second molecule: those of the first, but with model 1 and without an assembly.
ReadOptions besideReading(ReadOptions first);

/// Reads a molecule and the one named by `reading.beside`, which is searched beside its file, in the library and among
/// the fetched entries. Blocks.
Expected<Molecule> readSideBySide(const std::filesystem::path& file, const ReadOptions& reading);

}  // namespace moltact
