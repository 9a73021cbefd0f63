// The keys for reading a molecule's file (engine/molecule/molecule_key.h) in a lesson. Plain data; any thread but the
// haptic one.
#pragma once

#include "engine/lesson/keys.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// The key of a scene for one reading option.
KeySpec readingKey(const ReadingOption& option);

/// Stores the value of such a key in `reading`. Returns false, without a change, if the value is invalid.
bool readValue(ReadOptions& reading, const ReadingOption& option, const Value& value);

}  // namespace moltact
