// Spheres drawn exactly: one quad each, on which every pixel's ray is cut with the sphere, with its depth.
// Needs a current context. Colours are sRGB. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/gl_objects.h"
#include "engine/render/lighting.h"
#include "engine/render/molecule_model.h"
#include "engine/render/sphere_cull.h"

namespace moltact {

/// A sphere that belongs to no molecule: HIP, SCP, the atoms of the probe.
struct LooseSphere {
  glm::vec3 centre{0.0f};  ///< in the camera's axes
  float radius = 0.0f;
  std::uint32_t colour = 0xFFFFFFFFu;  ///< packColour; alpha is the opacity (of a shell: at its rim)
  glm::vec4 wide{0.0f};                ///< OcclusionField::wideRound, in the molecule's axes
};

class SphereImpostors {
 public:
  /// How spheres meet what is already drawn.
  enum class Pass {
    Solid,  ///< opaque, lit
    Ghost,  ///< only where something nearer hides it, at the colour's opacity
    Faint,  ///< at the colour's opacity, lit; the nearest of several alone where they come from front to back
    Shell,  ///< a clear bubble: strongest at its rim
  };

  static Expected<SphereImpostors> build();

  /// The `tinted` spheres (ascending) get the colour `tint`, and a ring as a target has. `rim` is the width at depth 1 of a dark edge
  /// round each sphere that stands well in front of what is behind it. With an opacity below 1 the spheres are a Faint pass.
  void drawMolecule(const MoleculeModel& model, std::span<const DrawnSphere> spheres,
                    std::span<const std::uint32_t> tinted, std::uint32_t tint, float rim, float opacity,
                    const Projection& projection, const Lighting& lighting);
  void drawLoose(std::span<const LooseSphere> spheres, Pass pass, const Projection& projection,
                 const Lighting& lighting);

 private:
  struct Vertex {
    float x, y;
    float centre_x, centre_y, centre_z, radius;
    std::uint32_t colour;
    std::uint32_t wide;  // what wideRound gives, turned to the camera's axes: x, y, z + 0.5, w as bytes
  };
  SphereImpostors() : stream_(std::make_unique<GlStream>()) {}
  void push(const DrawnSphere& sphere, std::uint32_t colour, std::uint32_t wide);
  void flush(Pass pass, float rim, const Projection& projection, const Lighting& lighting);

  GlProgram solid_, even_, open_, shell_;  // lit among others, finely or not; lit alone; bubbles
  std::unique_ptr<GlStream> stream_;
  std::vector<Vertex> vertices_;
};

}  // namespace moltact
