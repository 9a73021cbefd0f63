// The keys of a facts block. Each kind of fact names what is computed from the atoms that its lines select; checkFacts()
// (check.h) computes it. Plain data; any thread but the haptic one.
#pragma once

#include <vector>

#include "engine/lesson/keys.h"

namespace moltact {

/// The keys of the molecule, as in a scene, then one key per kind of fact.
std::vector<KeySpec> factKeys();

/// "9.38 Å", "53.1°", "12": a computed value with one more digit than the stated number.
std::string computedText(const KeySpec& kind, const FactSpec& fact, double computed);

}  // namespace moltact
