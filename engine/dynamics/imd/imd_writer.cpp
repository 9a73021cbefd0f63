#include "engine/dynamics/imd/imd_writer.h"

#include <bit>

namespace moltact {
namespace {

void addNumber(std::vector<std::uint8_t>& to, std::uint32_t value, bool little_endian) {
  for (int k = 0; k < 4; ++k) to.push_back(std::uint8_t(value >> 8 * (little_endian ? k : 3 - k)));
}

}  // namespace

void addImdMessage(std::vector<std::uint8_t>& to, ImdType type, std::int32_t value) {
  addNumber(to, std::uint32_t(type), false);
  addNumber(to, std::uint32_t(value), false);
}

void addImdForces(std::vector<std::uint8_t>& to, std::span<const ImdForce> forces, bool little_endian) {
  addImdMessage(to, ImdType::Forces, std::int32_t(forces.size()));
  for (const ImdForce& f : forces) addNumber(to, f.atom, little_endian);
  for (const ImdForce& f : forces)
    for (int k = 0; k < 3; ++k) addNumber(to, std::bit_cast<std::uint32_t>(float(f.force[k])), little_endian);
}

}  // namespace moltact
