// The engine OpenMM, in a module that is loaded at the first call: the program starts without the library. Not for the
// haptic thread; making an engine takes 0.1 to 1 s.
#pragma once

#include <memory>
#include <span>

#include "engine/core/problem.h"
#include "engine/dynamics/md_engine.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// An engine for this system, or a Problem with its remedy: the module or the library is missing, or the system cannot
/// be read. `file` is named by the Problem.
Expected<std::unique_ptr<MdEngine>> openMMEngine(const MdStart& start, const std::string& file);

/// Why these masses are not those of the molecule's atoms in their order, as a Problem without a file; an empty message
/// if they are. Hydrogens may be heavier by mass that their neighbours gave them.
Problem massFault(const Molecule& molecule, std::span<const double> masses_u);

}  // namespace moltact
