// Meshes that remain on the graphics card between pictures, lit like the spheres. Needs a current context.
#pragma once

#include "engine/render/gl_objects.h"
#include "engine/render/lighting.h"
#include "engine/render/mesh_piece.h"

namespace moltact {

/// A mesh on the graphics card.
class GpuMesh {
 public:
  explicit GpuMesh(const MeshPiece& piece);
  ~GpuMesh();
  GpuMesh(const GpuMesh&) = delete;
  GpuMesh& operator=(const GpuMesh&) = delete;

  const Vec3& origin_A() const { return origin_A_; }
  std::size_t triangles() const { return indices_ / 3; }
  void draw() const;

 private:
  GLuint array_ = 0, vertices_ = 0, elements_ = 0;
  std::size_t indices_ = 0;
  Vec3 origin_A_{0.0};
};

class MeshPass {
 public:
  static Expected<MeshPass> build();

  /// Draws into the bound framebuffer. With an opacity below 1 the background shows through the nearest wall, whose
  /// depth is kept.
  void draw(const GpuMesh& mesh, float opacity, const Projection& projection, const Lighting& lighting) const;

 private:
  GlProgram program_;
};

}  // namespace moltact
