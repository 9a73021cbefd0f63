// The balls of a molecule in blocks of neighbours, so that a block that is out of the picture or wholly behind others is
// passed over at once. Made once for a molecule, and refitted where its atoms move, in a time that follows n log n. Pure data; any thread. Units: angstrom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
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

  /// The same balls at other places, as many as there were: the blocks stay, and each lies round its balls again. Time
  /// follows the number of balls.
  void refit(std::span<const Ball> balls);
  /// Calls visit(index, ball) for every ball whose surface comes within margin_A of the place. `balls` are those that the
  /// blocks were made or refitted for.
  template <class Visit>
  void visitNear(std::span<const Ball> balls, const Vec3& place_A, double margin_A, Visit&& visit) const {
    for (const Block& block : blocks_) {
      if (glm::distance(block.centre_A, place_A) > block.radius_A + margin_A) continue;
      for (const std::uint32_t i : of(block))
        if (glm::distance(balls[i].centre_A, place_A) <= balls[i].radius_A + margin_A) visit(i, balls[i]);
    }
  }

  std::span<const Block> blocks() const { return blocks_; }
  /// The balls of a block, by index.
  std::span<const std::uint32_t> of(const Block& block) const {
    return {order_.data() + block.begin, std::size_t(block.end - block.begin)};
  }

 private:
  Block blockOf(std::span<const Ball> balls, std::uint32_t begin, std::uint32_t end) const;
  void split(std::span<const Ball> balls, std::uint32_t begin, std::uint32_t end);

  std::vector<std::uint32_t> order_;
  std::vector<Block> blocks_;
};

}  // namespace moltact
