// The engine OpenMM, in a module that is loaded at the first call: the program starts without the library. Not for the
// haptic thread; making an engine takes 0.1 to 1 s.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/dynamics/md_engine.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// An engine for this system, or a Problem with its remedy: the module or the library is missing, or the system cannot
/// be read. `file` is named by the Problem.
Expected<std::unique_ptr<MdEngine>> openMMEngine(const MdStart& start, const std::string& file);

/// An engine for the system in `system`, whose atoms are those of the molecule in their order and begin where they are;
/// `start` has the rest. A Problem names the file.
Expected<std::unique_ptr<MdEngine>> simulationOf(const std::filesystem::path& system, const Molecule& molecule,
                                                 MdStart start);
/// Larger molecules are not simulated: even the fastest engine would lag far behind the hand.
inline constexpr std::size_t kMaxSimulated = 5000;

/// Where a molecule's system is looked for: beside its file, with the ending .xml. It may not exist.
std::filesystem::path systemBeside(const std::filesystem::path& molecule_file);

/// The masses of the molecule's atoms by their elements; 1 u where the element is unknown (unit: dalton).
std::vector<double> massesOf(const Molecule& molecule);

/// Why these masses are not those of the molecule's atoms in their order, as a Problem without a file; an empty message
/// if they are. Hydrogens may be heavier by mass that their neighbours gave them.
Problem massFault(const Molecule& molecule, std::span<const double> masses_u);

}  // namespace moltact
