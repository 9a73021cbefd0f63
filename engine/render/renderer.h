// Draws a ViewScene. Needs a current OpenGL 3.3 core context, at construction and in every call; belongs to its thread.
// The atoms are cached as a layer that is redrawn only when the camera or the atoms change, so moving the probe costs
// the same for large and small molecules.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/core/problem.h"
#include "engine/render/picture.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct RenderOptions {
  int samples = 1;           ///< per pixel, along each edge, 1 to 4: 2 antialiases at 4 times the cost
  bool smooth_edges = true;  ///< with one sample: filter the edges
  bool outlines = true;      ///< dark rims around atoms in front of others
  bool fine_light = true;    ///< ambient occlusion varies within an atom; false: only between atoms
  float line_scale = 1.0f;   ///< factor on line widths, for displays with small pixels
  /// False: surfaces, and the light of moving atoms, are computed in the background; the previous ones stay meanwhile.
  bool wait_for_surfaces = true;
  bool occlusion_cull = true;  ///< skip atoms that others hide; the picture is the same

  friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// The cost and the contents of the last picture.
struct RenderCount {
  std::size_t atoms = 0, atoms_drawn = 0;
  bool atoms_redrawn = false;             ///< false: the cached layer was used
  std::optional<float> surface_progress;  ///< of a surface computed in the background, 0 to 1
  bool light_pending = false;             ///< light is being computed for a later picture
  std::uint64_t pictures = 0;             ///< number of pictures drawn; a changed value means a changed texture
};

class Renderer {
 public:
  /// Builds the shaders. A Problem contains the driver's message.
  static Expected<std::unique_ptr<Renderer>> create();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws into the renderer's own texture. On slow graphics, draw at a smaller size with a smaller line_scale and
  /// stretch the texture when showing it. Sizes are 1 to 16384 pixels. Does nothing if nothing has changed since the
  /// last call. Restores the caller's framebuffer, viewport and drawing state. Returns a Problem on failure (the driver
  /// refuses the size, a lost context).
  std::optional<Problem> draw(const ViewScene& scene, int width_px, int height_px, const RenderOptions& options = {});

  /// The last picture as an OpenGL texture (RGBA8, bottom row first), for ImGui::Image with uv (0,1) to (1,0).
  unsigned textureId() const;

  /// Copies the last picture into the bound framebuffer, with its lower left corner at (x, y).
  void copyTo(int x_px, int y_px) const;

  /// Returns the last picture. Blocks until it is drawn.
  Picture readPixels() const;

  /// Blocks until the picture is drawn, for measurements.
  void finish() const;

  /// Forces a complete redraw at the next call.
  void invalidate();

  const RenderCount& count() const;

 private:
  Renderer();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
