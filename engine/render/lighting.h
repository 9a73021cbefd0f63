// The one lighting of balls and solid glyphs. The light moves with the camera. Needs a current context.
#pragma once

#include "engine/render/gl_objects.h"
#include "engine/render/projection.h"

namespace moltact {

/// The light of a picture. Colours are sRGB.
struct Lighting {
  glm::vec3 background_top{0.0f}, background_bottom{0.0f};  ///< what distance fades into
  float fade_from_A = 1e9f, fade_over_A = 1.0f;             ///< depth where the fading begins, and over what length
  float fade_most = 0.0f;                                   ///< share of background at the far end (0 to 1)
  glm::mat3 rotation{1.0f};                                 ///< from the molecule's axes to the camera's
};

/// Sets the uniforms `Lighting` and `Projection` of a program that uses kLightingText; the program must be in use.
void setLighting(const GlProgram& program, const Projection& projection, const Lighting& lighting);

/// GLSL: vec3 lit(vec3 base, vec3 normal, float facing, float depth, float open, float y_ndc) and what it needs; `base`
/// is the squared colour, `facing` the cosine between the normal and the way to the eye.
extern const char* const kLightingText;

}  // namespace moltact
