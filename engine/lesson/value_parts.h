// What the readers of values share. Internal; pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/keys.h"

namespace moltact::values {

/// A problem at `part`, which lies within `text`.
Problem at(std::string_view text, std::string_view part, std::string message, std::string remedy = {});

/// `text` where the separator parts it, without spaces round the parts; what stands in double quotes is never parted.
std::vector<std::string_view> unquotedParts(std::string_view text, std::string_view separator);

/// The selection that `part` of `text` writes.
Expected<Selection> selectionIn(std::string_view text, std::string_view part);

/// Values of the types Marks and Places.
Expected<Value> marksValue(const KeySpec& key, std::string_view text, Value value);
Expected<Value> placesValue(const KeySpec& key, std::string_view text, Value value);

}  // namespace moltact::values
