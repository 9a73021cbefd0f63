// Selects the spheres of a molecule to draw: those in the picture that others do not hide entirely. Pure computation.
// Units: angstrom; NDC from -1 to 1, y up.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/render/projection.h"
#include "engine/render/sphere_blocks.h"

namespace moltact {

/// A sphere in the camera's axes with the bounding box of its image, or of the part that may be visible.
struct DrawnSphere {
  glm::vec3 centre{0.0f};
  float radius = 0.0f;
  glm::vec2 low{0.0f}, high{0.0f};  ///< corners in NDC
  std::uint32_t index = 0;          ///< into the scene
};

/// Computes the box of a sphere's image, enlarged by a rim (its width at depth 1). Returns false if the sphere
/// intersects the plane at near_A or lies outside the picture.
bool projectSphere(const Projection& projection, const glm::vec3& centre, float radius, DrawnSphere& out,
                   float rim = 0);

class SphereCull {
 public:
  /// Fills drawn() with the boxes to draw; a sphere gives none, one or several. Omitted parts are covered by nearer
  /// spheres, as determined on a coarse grid of cells, so the picture is unchanged. Without `occlusion` every sphere is
  /// kept entirely. `shown`, if not empty, contains a flag per sphere; zero excludes it. `blocks` must belong to
  /// `spheres`.
  void run(std::span<const Sphere> spheres, const SphereBlocks& blocks, const Camera& camera,
           const Projection& projection, float rim, bool occlusion, std::span<const std::uint8_t> shown = {});

  const std::vector<DrawnSphere>& drawn() const { return drawn_; }
  std::size_t atomsDrawn() const { return atoms_drawn_; }

 private:
  struct Span {
    int first, last;  // cells of a row
  };
  // A block in front of the eye.
  struct Near {
    DrawnSphere image;   // of the block's bounding sphere; `index` is that of the block
    bool boxed = false;  // false: it reaches the eye and may cover the whole picture
  };
  template <class ToView>
  std::vector<Near> blocksAhead(const SphereBlocks& blocks, const Projection& projection, float rim,
                                ToView&& toView) const;
  void makeCells(std::span<const Sphere> spheres, const SphereBlocks& blocks, std::span<const Near> near,
                 const Projection& projection);
  void sortSeen();
  Span inSight(const DrawnSphere& sphere, int row) const;
  bool hidden(const DrawnSphere& sphere) const;
  void emitBoxes(const DrawnSphere& sphere);
  void cover(const DrawnSphere& sphere);

  std::vector<DrawnSphere> seen_, found_, drawn_;  // possibly visible; of one block; the result
  std::size_t atoms_drawn_ = 0;
  std::vector<std::pair<float, std::uint32_t>> order_;  // into seen_, by depth
  std::vector<float> covered_;                          // per cell, the depth behind which everything is hidden
  std::vector<float> row_, row_before_;
  int cells_x_ = 0, cells_y_ = 0, cell_px_ = 4;
  float tan_x_ = 1, tan_y_ = 1, cell_x_ = 1, cell_y_ = 1;  // a cell's width and height in NDC
};

}  // namespace moltact
