// Makes the messages that an IMD client sends (imd_reader.h). Pure; any thread, one at a time for each vector.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/imd/imd_reader.h"

namespace moltact {

/// A force on an atom, counted from 0 among the atoms that the server sends. The unit is that of the session's version:
/// kcal/mol/A in version 2, kJ/mol/A in version 3.
struct ImdForce {
  std::uint32_t atom = 0;
  Vec3 force{0.0};
};

/// Appends a message without a body.
void addImdMessage(std::vector<std::uint8_t>& to, ImdType type, std::int32_t value = 0);
/// Appends the forces that replace all earlier ones; none: all forces end. Each atom at most once.
void addImdForces(std::vector<std::uint8_t>& to, std::span<const ImdForce> forces, bool little_endian);

}  // namespace moltact
