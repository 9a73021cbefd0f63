// The one lighting of spheres, solid glyphs and meshes. The light moves with the camera. Needs a current context.
#pragma once

#include "engine/render/ambient_occlusion.h"
#include "engine/render/camera.h"
#include "engine/render/gl_objects.h"
#include "engine/render/projection.h"

namespace moltact {

/// Where the strongest light comes from, in the camera's axes: the upper left, before the molecule.
inline constexpr glm::vec3 kKeyLight{-0.46f, 0.62f, 0.635f};

/// A molecule's occlusion field on the graphics card.
class OcclusionVolume {
 public:
  void upload(const OcclusionField& field);
  /// Sets the uniforms of a program that uses kLightingText; the program must be in use.
  void use(const GlProgram& program, const Camera& camera);

 private:
  GlVolume fine_, wide_;
  Vec3 low_A_{0.0};
  glm::vec3 fine_scale_{1.0f}, wide_scale_{1.0f};  // of angstroms to the textures' 0 to 1
};

/// The light of a picture. Colours are sRGB.
struct Lighting {
  glm::vec3 background_top{0.0f}, background_bottom{0.0f};  ///< what distance fades into
  float fade_from_A = 1e9f, fade_over_A = 1.0f;             ///< depth where the fading begins, and over what length
  float fade_most = 0.0f;                                   ///< share of background at the far end (0 to 1)
  Camera camera;                                            ///< whose picture it is
  glm::vec4 cut{0.0f, 0.0f, 0.0f,
                -1.0f};  ///< dot(xyz, place) + w > 0 is cut away, in the camera's axes (default: nothing)
  OcclusionVolume* occlusion = nullptr;  ///< of the molecule; null: everything lies open
  bool fine = true;                      ///< with its fine level, which a sphere looks up in every pixel
};

/// Sets the uniforms `Lighting` and `Projection` of a program that uses kLightingText; the program must be in use.
void setLighting(const GlProgram& program, const Projection& projection, const Lighting& lighting);

/// GLSL: bool cutAway(vec3 place); vec3 lit(vec3 base, vec3 place, vec3 normal, float facing, float y_ndc) and what it needs; `base` is the squared
/// colour, `place` in the camera's axes, `facing` the cosine between the normal and the way to the eye; where `fixed_open` is
/// set to 0 or more it stands for the light from all sides. Software looks nothing up only where the text says so:
/// "#define OPEN" before it leaves the occlusion out, "#define WIDE_GIVEN" takes its wide level from `wide_filled`,
/// "#define FINE_EVEN", only with that, puts the mean of the fine level in its place.
extern const std::string kLightingText;

}  // namespace moltact
