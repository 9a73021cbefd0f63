// The part of `moltact replay` in which the hand holds a rigid body.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/hip_path_file.h"
#include "engine/haptics/interactions.h"

namespace moltact {

/// The spheres of a file with the header `x,y,z,r` (angstrom). Throws CommandError with file, line and remedy where the
/// file is broken, has more than `most` of them, or a number that no sphere has.
std::vector<Sphere> readSpheres(const std::filesystem::path& file, std::size_t most);

/// Leads a body along the path and, where `out` is not empty, writes a row per tick: pose of the hand, pose of the body,
/// force and torque of springs of that stiffness, and whether the body has come to rest. Returns which ticks touch.
std::vector<char> replayBody(const InteractionInput& input, const HipPath& path, double stiffness_N_per_A,
                             const std::string& out);

}  // namespace moltact
