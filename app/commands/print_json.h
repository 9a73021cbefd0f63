// Prints a command's JSON to standard output.
#pragma once

#include <nlohmann/json.hpp>

namespace moltact {

/// Prints with an indent of two spaces and a final line end. Bytes that are not UTF-8, in names and paths, are
/// replaced; they do not throw. Characters that would control a terminal are escaped as \uXXXX, so that a JSON reader
/// gets them unchanged.
void printDocument(const nlohmann::ordered_json& json);

}  // namespace moltact
