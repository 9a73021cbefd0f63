// Triangles in a molecule's space, as created for a style. Plain data. Unit: angstrom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/core/units.h"

namespace moltact {

struct MeshPiece {
  struct Vertex {
    glm::vec3 place{0.0f}, normal{0.0f, 0.0f, 1.0f};  ///< position relative to `origin_A`; outward unit normal
    std::uint32_t colour = 0xFFFFFFFFu;               ///< packColour
  };
  Vec3 origin_A{0.0};
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise as seen from outside

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
};

}  // namespace moltact
