// Which spheres of a molecule have to be drawn: those in the picture and not wholly behind others. Pure arithmetic.
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

/// A sphere in the camera's axes with a box of its image: of the whole of it, or of the part that may be in sight.
struct DrawnSphere {
  glm::vec3 centre{0.0f};
  float radius = 0.0f;
  glm::vec2 low{0.0f}, high{0.0f};  ///< corners in NDC
  std::uint32_t index = 0;          ///< into the scene
};

/// The image box of a sphere widened by a rim (its width at depth 1); false when it touches the plane at near_A or lies
/// outside the picture.
bool projectSphere(const Projection& projection, const glm::vec3& centre, float radius, DrawnSphere& out,
                   float rim = 0);

class SphereCull {
 public:
  /// Fills drawn() with the spheres to draw, cut into boxes; a sphere may give none or several. A part that is left out is
  /// covered by nearer spheres, decided on a coarse grid of cells, so the picture is the same without it. `occlusion`
  /// false keeps every sphere whole.
  /// `shown`, if not empty, says of each sphere whether it is there at all.
  /// `blocks` are those of those spheres.
  void run(std::span<const Sphere> spheres, const SphereBlocks& blocks, const Camera& camera,
           const Projection& projection, float rim, bool occlusion, std::span<const std::uint8_t> shown = {});

  const std::vector<DrawnSphere>& drawn() const { return drawn_; }
  std::size_t atomsDrawn() const { return atoms_drawn_; }

 private:
  struct Span {
    int first, last;  // cells of a row
  };
  // A block that is ahead of the eye.
  struct Near {
    DrawnSphere image;   // of the sphere round the block; `index` is the block's
    bool boxed = false;  // false: it reaches to the eye, and its image everywhere
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

  std::vector<DrawnSphere> seen_, found_, drawn_;  // may be in sight; of one block; what is to be drawn of them
  std::size_t atoms_drawn_ = 0;
  std::vector<std::pair<float, std::uint32_t>> order_;  // into seen_, by depth
  std::vector<float> covered_;                          // for each cell the depth behind which nothing is seen
  std::vector<float> row_, row_before_;
  int cells_x_ = 0, cells_y_ = 0, cell_px_ = 4;
  float tan_x_ = 1, tan_y_ = 1, cell_x_ = 1, cell_y_ = 1;  // a cell's width and height in NDC
};

}  // namespace moltact
