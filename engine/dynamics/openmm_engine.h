// The engine OpenMM, in a module that is loaded at the first call: the program starts without the library. Not for the
// haptic thread; making an engine takes 0.1 to 1 s.
#pragma once

#include <memory>
#include <string>

#include "engine/core/problem.h"
#include "engine/dynamics/md_engine.h"

namespace moltact {

/// An engine for this system (simulation_engines.h), or a Problem with its remedy: the module or the library is missing,
/// or the system cannot be read. `file` is named by the Problem.
Expected<std::unique_ptr<MdEngine>> openMMEngine(const MdStart& start, const std::string& file);

/// That OpenMM, in its own words, cannot simulate the system in this file.
Problem openMMRefusal(const std::string& file, const std::string& why);

}  // namespace moltact
