// Reads and writes little-endian numbers in a report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace moltact {

inline std::int16_t int16At(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
}
inline std::uint16_t uint16At(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(int16At(bytes, at));
}
inline void putInt16(std::span<std::uint8_t> bytes, std::size_t at, int value) {
  bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
  bytes[at + 1] = static_cast<std::uint8_t>((value >> 8) & 0xFF);
}

}  // namespace moltact
