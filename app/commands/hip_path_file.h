// A HIP path as a file: the header `x,y,z`, then a row a tick. Units: angstrom.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

/// The places in the file, in order; blanks around the fields, a plus sign and a UTF-8 byte order mark are accepted. A
/// Problem where it is no ordinary file, larger than 1 GiB or broken. "nan" and "inf" are read as such: a tracker must
/// accept them.
Expected<std::vector<PointA>> readHipPath(const std::filesystem::path& file);

}  // namespace moltact
