// The part of `moltact replay` for a rigid body in the hand.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/commands/hip_path_file.h"
#include "engine/haptics/interactions.h"

namespace moltact {

/// Reads the spheres of a file with the header `x,y,z,r` (angstrom). Throws CommandError with file, line and remedy if
/// the file is malformed, has more than `max` spheres, or a number that is invalid for a sphere.
std::vector<Sphere> readSpheres(const std::filesystem::path& file, std::size_t max);

/// Writes spheres in the same format. Throws CommandError if the file cannot be written.
void writeSpheres(const std::string& file, std::span<const Sphere> spheres);

/// The spheres of the scene that can be felt.
std::vector<Sphere> touchableSpheres(const SphereGrid& scene);

/// Moves a body along the path. If `out` is not empty, writes one row per tick. A row has the pose of the hand, the
/// pose of the body, force and torque of springs with that stiffness, and whether the body is at rest. Returns for each
/// tick whether it touches.
std::vector<char> replayBody(const InteractionInput& input, const HipPath& path, double stiffness_N_per_A,
                             const std::string& out);

}  // namespace moltact
