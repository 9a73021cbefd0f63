// How a molecule's file is read (engine/molecule/molecule_key.h), as authors write it. Plain data; any thread but the
// haptic one.
#pragma once

#include "engine/lesson/keys.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// The key of a scene for one way of reading.
KeySpec readingKey(const ReadingOption& option);

/// Takes over what a value of such a key says; false, and nothing changed, where it is not sound.
bool readValue(ReadOptions& reading, const ReadingOption& option, const Value& value);

}  // namespace moltact
