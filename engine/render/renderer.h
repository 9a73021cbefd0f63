// Draws a ViewScene. Needs a current OpenGL 3.3 core context, at construction and in every call; belongs to its thread.
// The atoms are kept as a layer and drawn again only when the camera or the atoms change, so that moving the probe over
// a large molecule costs no more than over a small one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/core/problem.h"
#include "engine/render/picture.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct RenderOptions {
  int samples = 1;  ///< samples along each pixel's edge, 1 to 4: 2 smooths the edges at 4 times the cost (default 1)
  bool smooth_edges = true;  ///< with one sample the edges are filtered (default on)
  bool outlines = true;      ///< dark rims round atoms that stand in front of others (default on)
  bool fine_light = true;    ///< ambient occlusion varies within an atom; false: from atom to atom only (default on)
  float line_scale = 1.0f;   ///< multiplies line widths, for displays with small pixels (default 1)
  /// False: surfaces, and the light of atoms that move, are computed beside; the former ones stay meanwhile.
  bool wait_for_surfaces = true;
  bool occlusion_cull = true;  ///< leave out atoms that are hidden by others; the picture is the same (default on)

  friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// The cost and the contents of the last picture.
struct RenderCount {
  std::size_t atoms = 0, atoms_drawn = 0;
  bool atoms_redrawn = false;             ///< false when the kept layer was used
  std::optional<float> surface_progress;  ///< of a surface that is computed beside, 0 to 1
  bool light_pending = false;             ///< light is computed beside, for the next picture
  std::uint64_t pictures = 0;             ///< drawn so far: the texture holds another one where this is another number
};

class Renderer {
 public:
  /// Builds the shaders; fails with the driver's words.
  static Expected<std::unique_ptr<Renderer>> create();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws into the renderer's own texture. Where graphics are slow, a smaller size with a smaller line_scale,
  /// stretched by whoever shows the texture, keeps a turning picture fluent. Sizes are 1 to 16384 pixels. Does nothing
  /// if nothing has changed since the last call. The framebuffer, the viewport and the drawing state of the caller are
  /// put back. Returns what went wrong (a size that the driver refuses, a lost context), or nothing.
  std::optional<Problem> draw(const ViewScene& scene, int width_px, int height_px, const RenderOptions& options = {});

  /// The last picture as an OpenGL texture (RGBA8, first row at the bottom), for ImGui::Image with uv (0,1) to (1,0).
  unsigned textureId() const;

  /// Copies the last picture into the bound framebuffer at (x, y) from the lower left corner.
  void copyTo(int x_px, int y_px) const;

  /// The last picture.
  Picture readPixels() const;

  /// Waits until the picture is really drawn: for measuring.
  void finish() const;

  /// Draws everything again at the next call.
  void invalidate();

  const RenderCount& count() const;

 private:
  Renderer();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
