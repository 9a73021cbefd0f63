// Numbers that look random and are the same on every machine: SplitMix64 (Steele, Lea & Flood 2014). Not against
// someone who wants to guess them. Any thread.
#pragma once

#include <cstdint>

namespace moltact {

/// The next of the row that `state` stands in.
inline std::uint64_t nextRandom(std::uint64_t& state) {
  std::uint64_t z = state += 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

/// The next one as a fraction: 0 to 1, 1 excluded.
inline double nextFraction(std::uint64_t& state) { return double(nextRandom(state) >> 11) * 0x1p-53; }

/// A seed that follows from two.
inline std::uint64_t mixedSeed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t state = a ^ (b * 0xD6E8FEB86659FD93u);
  return nextRandom(state);
}

}  // namespace moltact
