// The common lighting of spheres, solid glyphs and meshes. The light moves with the camera. Needs a current context.
#pragma once

#include "engine/render/ambient_occlusion.h"
#include "engine/render/camera.h"
#include "engine/render/gl_objects.h"
#include "engine/render/projection.h"

namespace moltact {

/// The direction toward the key light, in the camera's axes: the upper left, in front of the molecule.
inline constexpr glm::vec3 kKeyLight{-0.46f, 0.62f, 0.635f};

/// A molecule's occlusion field on the graphics card.
class OcclusionVolume {
 public:
  void upload(const OcclusionField& field);
  /// Sets the uniforms of the program in use, which must contain kLightingText.
  void use(const GlProgram& program, const Camera& camera);

 private:
  GlVolume fine_, wide_;
  Vec3 low_A_{0.0};
  glm::vec3 fine_scale_{1.0f}, wide_scale_{1.0f};  // from angstroms to texture coordinates 0 to 1
};

/// The lighting of a picture. Colours are sRGB.
struct Lighting {
  glm::vec3 background_top{0.0f}, background_bottom{0.0f};  ///< the colours into which distant parts fade
  float fade_from_A = 1e9f, fade_over_A = 1.0f;             ///< depth at which fading begins, and its length
  float max_fade = 0.0f;                                    ///< fraction of background at the far end (0 to 1)
  Camera camera;                                            ///< of the picture
  /// Cut plane in the camera's axes: points with dot(xyz, place) + w > 0 are cut away (default: none).
  glm::vec4 cut{0.0f, 0.0f, 0.0f, -1.0f};
  OcclusionVolume* occlusion = nullptr;  ///< of the molecule; null: nothing is occluded
  bool fine = true;                      ///< use the fine level, which a sphere samples in every pixel
};

/// Sets the uniforms `Lighting` and `Projection` of the program in use, which must contain kLightingText.
void setLighting(const GlProgram& program, const Projection& projection, const Lighting& lighting);

/// GLSL: `bool cutAway(vec3 place)`, `vec3 lit(vec3 base, vec3 place, vec3 normal, float facing, float y_ndc)` and
/// helpers. `base` is the squared colour, `place` in the camera's axes, `facing` the cosine between the normal and the
/// direction to the eye. If `fixed_open` is 0 or more it replaces the ambient light. Preprocessor symbols defined
/// before the text avoid texture accesses: OPEN omits the occlusion; WIDE_GIVEN takes the wide level from
/// `wide_filled`; FINE_EVEN, only together with WIDE_GIVEN, uses the mean of the fine level.
extern const std::string kLightingText;

}  // namespace moltact
