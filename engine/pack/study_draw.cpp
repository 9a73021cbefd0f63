#include "engine/pack/study_draw.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "engine/core/random.h"

namespace moltact {
namespace {

constexpr std::string_view kCodeSigns = "23456789ABCDEFGHJKLMNPQRSTUVWXYZ";

// A number from 0 to n - 1, each with the same probability.
std::size_t drawn(std::uint64_t& state, std::size_t n) {
  const std::uint64_t limit = ~std::uint64_t{0} - ~std::uint64_t{0} % n;
  std::uint64_t value = 0;
  do value = nextRandom(state);
  while (value >= limit);
  return std::size_t(value % n);
}

}  // namespace

std::vector<std::size_t> permutedBlocks(std::size_t n, std::size_t groups, std::size_t block, std::uint64_t seed) {
  std::uint64_t state = mixedSeed(seed, 1);
  std::vector<std::size_t> out;
  while (out.size() < n) {
    std::vector<std::size_t> next(block);
    for (std::size_t k = 0; k < block; ++k) next[k] = k % groups;
    for (std::size_t k = block; k > 1; --k) std::swap(next[k - 1], next[drawn(state, k)]);
    out.insert(out.end(), next.begin(), next.end());
  }
  out.resize(n);
  return out;
}

std::vector<std::string> studyCodes(std::size_t n, std::uint64_t seed) {
  constexpr std::size_t kFree = 4;
  std::uint64_t state = mixedSeed(seed, 2);
  std::vector<std::string> out;
  std::set<std::string> taken;
  while (out.size() < n) {
    // The last sign is the sum of the others, so that codes that differ at one place do not exist.
    std::string code;
    std::size_t sum = 0;
    for (std::size_t k = 0; k < kFree; ++k) {
      const std::size_t sign = drawn(state, kCodeSigns.size());
      code += kCodeSigns[sign];
      sum += sign;
    }
    code += kCodeSigns[sum % kCodeSigns.size()];
    if (taken.insert(code).second) out.push_back(std::move(code));
  }
  return out;
}

}  // namespace moltact
