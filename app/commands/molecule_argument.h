// The MOLECULE argument of the headless commands.
#pragma once

#include <memory>
#include <string>

#include "engine/molecule/molecule.h"

namespace moltact {

/// The molecule that an argument names. Throws CommandError with the problem's text.
std::shared_ptr<const Molecule> moleculeArgument(const std::string& argument);

}  // namespace moltact
