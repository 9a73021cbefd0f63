// Identifies a content by its 64-bit FNV-1a hash. Not secure against deliberate collisions. Any thread except the
// haptic one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace moltact {

inline std::uint64_t hash64(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ull;
  }
  return hash;
}

/// The hash as 16 hexadecimal digits.
inline std::string contentHash(std::string_view bytes) {
  std::uint64_t hash = hash64(bytes);
  std::string out(16, '0');
  for (std::size_t k = 16; k > 0; --k, hash >>= 4) out[k - 1] = "0123456789abcdef"[hash & 15u];
  return out;
}

}  // namespace moltact
