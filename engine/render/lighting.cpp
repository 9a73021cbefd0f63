#include "engine/render/lighting.h"

#include <cmath>

namespace moltact {
namespace {

constexpr unsigned kFineUnit = 2, kWideUnit = 3;

// The sRGB curve is approximated by squares and square roots. The occlusion is OcclusionField::open.
const char* const kText = R"(
uniform vec3 u_top, u_bottom;
uniform vec3 u_fade;  // from, 1 / over, most
uniform vec3 u_key;
uniform float u_occluded;  // 0: nothing is
uniform mat4 u_to_field;   // from the camera's axes to angstroms from the field's corner
uniform vec3 u_fine_scale, u_wide_scale;
uniform sampler3D u_fine, u_wide;
uniform vec4 u_cut;
#define CAP_SHADE 0.62
float fixed_open = -1.0, wide_filled = -1.0;
bool cutAway(vec3 place) { return dot(u_cut.xyz, place) + u_cut.w > 0.0; }
float openness(vec3 place, vec3 n) {
#ifndef FINE_EVEN
  vec3 at = (u_to_field * vec4(place, 1.0)).xyz, way = mat3(u_to_field) * n;
  float fine = textureLod(u_fine, (at + way * kFineOut) * u_fine_scale, 0.0).r;
  float creased = clamp((fine - kMinFineFill) / (kMaxFineFill - kMinFineFill), 0.0, 1.0);
#else
  float creased = 0.35;  // mean of the visible points of a protein
#endif
#ifdef WIDE_GIVEN
  float wide = wide_filled;
#else
  float wide = textureLod(u_wide, (at + way * kWideOut) * u_wide_scale, 0.0).r;
#endif
  float enclosed = clamp((wide - kMinWideFill) / (kMaxWideFill - kMinWideFill), 0.0, 1.0);
  return (1.0 - kFineShade * creased) * (1.0 - kWideShade * enclosed);
}
vec3 lit(vec3 base, vec3 place, vec3 n, float facing, float y_ndc) {
#ifdef OPEN
  float open = fixed_open >= 0.0 ? fixed_open : 1.0;
#else
  float open = fixed_open >= 0.0 ? fixed_open : u_occluded > 0.0 ? openness(place, n) : 1.0;
#endif
  float key = max(dot(n, u_key) * 0.80 + 0.20, 0.0);
  float fill = max(dot(n, vec3(0.70, -0.10, 0.707)) * 0.70 + 0.30, 0.0);
  float sky = 0.66 + 0.34 * n.y;
  vec3 light = base * (open * (0.44 * sky * vec3(0.95, 0.99, 1.07) + 0.16 * fill * vec3(0.96, 0.98, 1.05)) +
                       0.66 * key * (0.30 + 0.70 * open) * vec3(1.04, 1.0, 0.95));
  float shine = max(dot(n, normalize(u_key + vec3(0.0, 0.0, 1.0))), 0.0);  // for an eye straight ahead
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
  light += 0.07 * shine * open;
  float rim = 1.0 - min(facing * 2.0, 1.0);
  light *= 1.0 - 0.55 * rim * rim;
  vec3 ground = mix(u_bottom, u_top, 0.5 + 0.5 * y_ndc);
  float fade = u_fade.z * clamp((-place.z - u_fade.x) * u_fade.y, 0.0, 1.0);
  return sqrt(mix(light * 1.12, ground * ground, fade));
}
)";

std::string withNumbers() {
  std::string text;
  for (const auto& [name, value] : {std::pair{"kFineOut", kFineOut_A}, std::pair{"kWideOut", kWideOut_A},
                                    std::pair{"kMinFineFill", kMinFineFill}, std::pair{"kMaxFineFill", kMaxFineFill},
                                    std::pair{"kMinWideFill", kMinWideFill}, std::pair{"kMaxWideFill", kMaxWideFill},
                                    std::pair{"kFineShade", kFineShade}, std::pair{"kWideShade", kWideShade}}) {
    text += std::string("const float ") + name + " = " + std::to_string(std::lround(1e4 * value)) + ".0 / 10000.0;\n";
  }
  return text + kText;
}

glm::vec3 scaleOf(const OcclusionLevel& level) { return 1.0f / (glm::vec3(level.size) * float(level.voxel_A)); }

}  // namespace

const std::string kLightingText = withNumbers();

void OcclusionVolume::upload(const OcclusionField& field) {
  low_A_ = field.low_A;
  fine_.upload(field.fine.size.x, field.fine.size.y, field.fine.size.z, field.fine.filled.data());
  wide_.upload(field.wide.size.x, field.wide.size.y, field.wide.size.z, field.wide.filled.data());
  fine_scale_ = scaleOf(field.fine);
  wide_scale_ = scaleOf(field.wide);
}

void OcclusionVolume::use(const GlProgram& program, const Camera& camera) {
  glm::mat4 to_field(glm::mat3(glm::mat3_cast(camera.orientation)));
  to_field[3] = glm::vec4(glm::vec3(camera.eye().A - low_A_), 1.0f);
  fine_.bind(kFineUnit);
  wide_.bind(kWideUnit);
  glUniformMatrix4fv(program.uniform("u_to_field"), 1, GL_FALSE, &to_field[0][0]);
  glUniform3fv(program.uniform("u_fine_scale"), 1, &fine_scale_.x);
  glUniform3fv(program.uniform("u_wide_scale"), 1, &wide_scale_.x);
}

void setLighting(const GlProgram& program, const Projection& projection, const Lighting& lighting) {
  glUniform3fv(program.uniform("u_top"), 1, &lighting.background_top.x);
  glUniform3fv(program.uniform("u_bottom"), 1, &lighting.background_bottom.x);
  glUniform3f(program.uniform("u_fade"), lighting.fade_from_A, 1.0f / lighting.fade_over_A, lighting.max_fade);
  glUniform3fv(program.uniform("u_key"), 1, &kKeyLight.x);
  glUniform2f(program.uniform("u_tan"), projection.tan_x, projection.tan_y);
  glUniform2f(program.uniform("u_depth"), projection.depthScale(), projection.depthOffset());
  glUniform4fv(program.uniform("u_cut"), 1, &lighting.cut.x);
  glUniform1i(program.uniform("u_fine"), kFineUnit);
  glUniform1i(program.uniform("u_wide"), kWideUnit);
  glUniform1f(program.uniform("u_occluded"), lighting.occlusion ? 1.0f : 0.0f);
  if (lighting.occlusion) lighting.occlusion->use(program, lighting.camera);
}

}  // namespace moltact
