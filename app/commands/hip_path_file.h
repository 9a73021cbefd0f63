// Reads a HIP path from a file: the header `x,y,z`, then one row per tick. Unit: angstrom.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

/// Returns the positions in the order of the file. Blanks around a field, a plus sign and a UTF-8 byte order mark are
/// accepted. "nan" and "inf" are read as such, because trackers must accept them. Returns a Problem if the file is not
/// a regular file, exceeds 1 GiB or is malformed.
Expected<std::vector<PointA>> readHipPath(const std::filesystem::path& file);

}  // namespace moltact
