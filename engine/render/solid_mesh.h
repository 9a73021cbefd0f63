// Solid glyphs made of triangles (the force arrow, the bonds of the probe's water), lit like the spheres. Needs a
// current context. Positions in the camera's axes (unit: angstrom).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/render/sphere_impostors.h"

namespace moltact {

struct SolidModel;

class SolidMesh {
 public:
  static Expected<SolidMesh> build();

  /// A truncated cone from a to b with radii `radius_a` and `radius_b` (0 gives a tip), closed at a.
  void addCone(const glm::vec3& a, const glm::vec3& b, float radius_a, float radius_b, std::uint32_t colour);

  /// Adds a model with a conformal transform to the camera's axes.
  void addModel(const SolidModel& model, const glm::mat4& to_view);

  /// Draws and clears the added shapes. With `ghost` above 0, hidden parts are first drawn with that opacity.
  void draw(const Projection& projection, const Lighting& lighting, float ghost);

 private:
  struct Vertex {
    glm::vec3 place, normal;
    std::uint32_t colour;
  };
  SolidMesh() : stream_(std::make_unique<GlStream>()) {}

  GlProgram program_;
  std::unique_ptr<GlStream> stream_;
  std::vector<Vertex> vertices_;
};

}  // namespace moltact
