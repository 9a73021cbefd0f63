// The way of a recorded hand beside a lesson, for a guide: a recording of this program (`.recording`), or rows of numbers
// (engine/servo/hand_path.h) in the molecule's space. Not for the haptic thread. Units: angstrom.
#pragma once

#include <filesystem>

#include "engine/core/problem.h"
#include "engine/haptics/guide/guide.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Points of a recorded way that are nearer to their predecessor are left out.
inline constexpr double kGuideSpacing_A = 0.1;

/// The part of the way from the first contact to the last, or all of it where the file tells of no contact. A Problem
/// with the file's name if it cannot be read, was recorded with other atoms or is in a device's millimetres. The same
/// applies if the hand stays at one place, or the way has more than GuidePath::kMaxPoints points.
Expected<GuidePath> readGuidePath(const std::filesystem::path& file, const Molecule& molecule);

}  // namespace moltact
