// What a scene is felt with (engine/haptics/touch_setup.h), as authors write it. Plain data; any thread but the haptic
// one.
#pragma once

#include "engine/haptics/touch_setup.h"
#include "engine/lesson/keys.h"

namespace moltact {

/// The keys of a scene that say what it is felt with: of every property that leaves a choice.
std::vector<KeySpec> touchSceneKeys();

/// The keys of a task that compares the scene with another, which differs in one of them.
std::vector<KeySpec> comparedTouchKeys();

/// What a value of such a key says.
TouchValue touchValueOf(const TouchProperty& property, const Value& value);

}  // namespace moltact
