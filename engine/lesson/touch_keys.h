// The keys for a scene's touch (engine/haptics/touch_setup.h) in a lesson. Plain data; any thread but the haptic one.
#pragma once

#include "engine/haptics/touch_setup.h"
#include "engine/lesson/keys.h"

namespace moltact {

/// The keys of a scene for every touch property that has a choice.
std::vector<KeySpec> touchSceneKeys();

/// The keys of a task that compares the scene with another one, which differs in one of them.
std::vector<KeySpec> comparedTouchKeys();

/// Converts the value of such a key.
TouchValue touchValueOf(const TouchProperty& property, const Value& value);

}  // namespace moltact
