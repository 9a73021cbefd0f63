// Unpacks gzip in memory. Inside engine/molecule only.
#pragma once

#include <string>

#include "engine/core/problem.h"

namespace moltact {

/// True where the bytes begin as gzip does.
bool isGzip(std::string_view bytes);

/// The unpacked content, all members of the file one after another; a Problem where it is cut, damaged or
/// unpacks to more than `most` bytes.
Expected<std::string> inflateGzip(std::string_view bytes, std::size_t most, const std::string& file);

}  // namespace moltact
