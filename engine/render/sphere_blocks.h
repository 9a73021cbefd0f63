// Groups the spheres of a molecule into blocks of neighbours, so that a block outside the picture or entirely hidden is
// skipped at once. Built once per molecule in O(n log n); refitted in O(n) after a motion. Pure data; any thread.
// Units: angstrom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact {

class SphereBlocks {
 public:
  static constexpr std::size_t kMax = 48;  ///< spheres per block

  struct Block {
    Vec3 centre_A{0.0};
    double radius_A = 0.0;  ///< of the bounding sphere of the block
    std::uint32_t begin = 0, end = 0;
  };

  SphereBlocks() = default;
  explicit SphereBlocks(std::span<const Sphere> spheres);

  /// Adapts the bounding spheres to the same spheres at other positions; the blocks are kept. O(n).
  void refit(std::span<const Sphere> spheres);
  /// Calls visit(index, sphere) for every sphere whose surface is within margin_A of the point. `spheres` must be those
  /// of the construction or the last refit().
  template <class Visit>
  void visitNear(std::span<const Sphere> spheres, const Vec3& place_A, double margin_A, Visit&& visit) const {
    for (const Block& block : blocks_) {
      if (glm::distance(block.centre_A, place_A) > block.radius_A + margin_A) continue;
      for (const std::uint32_t i : of(block))
        if (glm::distance(spheres[i].centre_A, place_A) <= spheres[i].radius_A + margin_A) visit(i, spheres[i]);
    }
  }

  std::span<const Block> blocks() const { return blocks_; }
  /// The spheres of a block, by index.
  std::span<const std::uint32_t> of(const Block& block) const {
    return {order_.data() + block.begin, std::size_t(block.end - block.begin)};
  }

 private:
  Block blockOf(std::span<const Sphere> spheres, std::uint32_t begin, std::uint32_t end) const;
  void split(std::span<const Sphere> spheres, std::uint32_t begin, std::uint32_t end);

  std::vector<std::uint32_t> order_;
  std::vector<Block> blocks_;
};

}  // namespace moltact
