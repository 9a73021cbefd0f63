// The balls of a molecule in blocks of neighbours, so that a block that is out of the picture or wholly behind others is
// passed over at once. Made once for a molecule, in a time that follows n log n. Pure data; any thread. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/ball.h"

namespace moltact {

class BallBlocks {
 public:
  static constexpr std::size_t kMost = 48;  ///< balls in a block

  struct Block {
    Vec3 centre_A{0.0};
    double radius_A = 0.0;  ///< all balls of the block lie within it
    std::uint32_t begin = 0, end = 0;
  };

  BallBlocks() = default;
  explicit BallBlocks(std::span<const Ball> balls);

  std::span<const Block> blocks() const { return blocks_; }
  /// The balls of a block, by index.
  std::span<const std::uint32_t> of(const Block& block) const {
    return {order_.data() + block.begin, std::size_t(block.end - block.begin)};
  }

 private:
  void split(std::span<const Ball> balls, std::uint32_t begin, std::uint32_t end);

  std::vector<std::uint32_t> order_;
  std::vector<Block> blocks_;
};

}  // namespace moltact
