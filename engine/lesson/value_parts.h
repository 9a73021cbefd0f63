// Helpers of the value parsers. Internal; pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/keys.h"

namespace moltact::values {

/// A Problem at `part`, which must be a view into `text`.
Problem at(std::string_view text, std::string_view part, std::string message, std::string remedy = {});

/// Splits `text` at the separator and strips the parts. Text in double quotes is never split.
std::vector<std::string_view> unquotedParts(std::string_view text, std::string_view separator);

/// Parses the selection in `part`, a view into `text`.
Expected<Selection> selectionIn(std::string_view text, std::string_view part);

/// Parse values of the types Marks and Places.
Expected<Value> marksValue(const KeySpec& key, std::string_view text, Value value);
Expected<Value> placesValue(const KeySpec& key, std::string_view text, Value value);

}  // namespace moltact::values
