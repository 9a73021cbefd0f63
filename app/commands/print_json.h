// How a command prints JSON to standard output.
#pragma once

#include <nlohmann/json.hpp>

namespace moltact {

/// Two places an indent, and a line end. Bytes that are no UTF-8 (of names and paths) are replaced and not thrown over;
/// what would steer a terminal is escaped as \uXXXX, so that who reads the JSON gets it as it was.
void printDocument(const nlohmann::ordered_json& json);

}  // namespace moltact
