// Exact spheres: one quad each, in which every pixel intersects its ray with the sphere and writes the depth. Needs a
// current context. Colours are sRGB. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/gl_objects.h"
#include "engine/render/lighting.h"
#include "engine/render/molecule_model.h"
#include "engine/render/sphere_cull.h"

namespace moltact {

/// A sphere outside the molecule: HIP, SCP, the atoms of the probe.
struct LooseSphere {
  glm::vec3 centre{0.0f};  ///< in the camera's axes
  float radius = 0.0f;
  std::uint32_t colour = 0xFFFFFFFFu;  ///< packColour; alpha is the opacity (for a shell: at its rim)
  glm::vec4 wide{0.0f};                ///< OcclusionField::wideRound, in the molecule's axes
};

class SphereImpostors {
 public:
  /// How spheres are combined with the picture below them.
  enum class Pass {
    Solid,  ///< opaque, lit
    Ghost,  ///< drawn only where something nearer hides it, with the colour's opacity
    Faint,  ///< lit, with the colour's opacity; in front-to-back order only the nearest of several
    Shell,  ///< a transparent bubble, most opaque at its rim
  };

  static Expected<SphereImpostors> build();

  /// The `tinted` spheres (ascending) get the colour `tint` and the ring of a target. `rim` is the width at depth 1 of
  /// a dark edge around each sphere that is well in front of its background. An opacity below 1 selects the pass Faint.
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
    std::uint32_t wide;  // wideRound() in the camera's axes: x, y, z + 0.5, w as bytes
  };
  SphereImpostors() : stream_(std::make_unique<GlStream>()) {}
  void push(const DrawnSphere& sphere, std::uint32_t colour, std::uint32_t wide);
  void flush(Pass pass, float rim, const Projection& projection, const Lighting& lighting);

  GlProgram solid_, even_, open_, shell_;  // with fine light; with even light; without occlusion; bubbles
  std::unique_ptr<GlStream> stream_;
  std::vector<Vertex> vertices_;
};

}  // namespace moltact
