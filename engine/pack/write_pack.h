// Files as the bytes of a pack (pack_file.h). Any thread but the haptic one.
#pragma once

#include <map>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

/// `files`: contents by name; `lesson` is one of them. Of the same files always the same bytes. A Problem without a
/// file where libzip cannot make it.
Expected<std::string> writePack(const std::string& lesson, const std::map<std::string, std::string>& files);

}  // namespace moltact
