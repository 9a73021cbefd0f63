// The spheres of a molecule in blocks of neighbours, so that a block that is out of the picture or wholly behind others is
// passed over at once. Made once for a molecule, and refitted where its atoms move, in a time that follows n log n. Pure data; any thread. Units: angstrom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact {

class SphereBlocks {
 public:
  static constexpr std::size_t kMax = 48;  ///< spheres in a block

  struct Block {
    Vec3 centre_A{0.0};
    double radius_A = 0.0;  ///< all spheres of the block lie within it
    std::uint32_t begin = 0, end = 0;
  };

  SphereBlocks() = default;
  explicit SphereBlocks(std::span<const Sphere> spheres);

  /// The same spheres at other places, as many as there were: the blocks stay, and each lies round its spheres again. Time
  /// follows the number of spheres.
  void refit(std::span<const Sphere> spheres);
  /// Calls visit(index, sphere) for every sphere whose surface comes within margin_A of the place. `spheres` are those that the
  /// blocks were made or refitted for.
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
