// Checks a lesson against its molecules: molecules that there are, selections that select atoms.
// Not for the haptic thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// The molecule of that name in the library, or why it cannot be had.
using MoleculeByName = std::function<Expected<std::shared_ptr<const Molecule>>(const std::string& name)>;

/// Every problem, in the order of the file, each at its place in the lesson. Each molecule is asked for once.
std::vector<Problem> checkAgainstMolecules(const Lesson& lesson, const MoleculeByName& molecule);

}  // namespace moltact
