// Pseudo-random numbers that are equal on every machine: SplitMix64 (Steele, Lea & Flood 2014). Not cryptographically
// secure. Any thread.
#pragma once

#include <cstdint>

namespace moltact {

/// Returns the next number of the sequence and advances `state`.
inline std::uint64_t nextRandom(std::uint64_t& state) {
  std::uint64_t z = state += 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

/// Returns the next number as a fraction in [0, 1).
inline double nextFraction(std::uint64_t& state) { return double(nextRandom(state) >> 11) * 0x1p-53; }

/// Combines two seeds into one.
inline std::uint64_t mixedSeed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t state = a ^ (b * 0xD6E8FEB86659FD93u);
  return nextRandom(state);
}

}  // namespace moltact
