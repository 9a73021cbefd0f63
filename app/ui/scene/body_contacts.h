// The contacts of a held body, for the picture and the words. Computed on the window's thread from a tick. Unit:
// angstrom.
#pragma once

#include <span>

#include "app/ui/scene/touchable_model.h"
#include "engine/render/loaded_atoms.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// A drawn body's atom with a smaller gap to the molecule counts as stopped where the reactions are not known.
inline constexpr double kAtRest_A = 0.02;

/// The contacts of a tick from its reactions. Without reactions, as in a playback, the body's atoms within kAtRest_A of
/// the molecule count as stopped with equal shares, and the molecule's atoms are those of the contact. Empty without a
/// body and without a touch.
LoadedAtoms bodyContacts(const TouchableModel& stage, const ServoSample& now, std::span<const AtomForce> reactions,
                         const SphereMotion* motion = nullptr);

}  // namespace moltact
