// Writes files into the bytes of a pack (pack_file.h). Any thread except the haptic one.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// `files`: contents by name; `lesson` is one of the names. Reproducible: equal files give equal bytes. Returns a
/// Problem without a file name if libzip fails.
Expected<std::string> writePack(const std::string& lesson, const std::map<std::string, std::string>& files);

/// A zip of files, in this order. As reproducible as a pack.
Expected<std::string> writeZip(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace moltact
