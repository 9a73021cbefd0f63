// Parses a pose as authors write it: "X, Y, Z" in angstroms, or "X, Y, Z, QW, QX, QY, QZ" with a quaternion relative to
// the molecule's file. Pure function; any thread.
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

struct WrittenPose {
  PointA place;
  std::optional<Quat> orientation;  ///< normalised; empty where three numbers were given
};

/// A Problem has line 0 and the column within `text`.
Expected<WrittenPose> parsePose(std::string_view text);

}  // namespace moltact
