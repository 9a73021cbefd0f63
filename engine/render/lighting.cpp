#include "engine/render/lighting.h"

namespace moltact {

// Squares and roots stand in for the sRGB curve. A wrapped key light from the upper left, a sky and a ground, a small
// highlight; rims and closed-in places darken, distance fades: each tells depth at a glance.
const char* const kLightingText = R"(
uniform vec3 u_top, u_bottom;
uniform vec3 u_fade;  // from, 1 / over, most
vec3 lit(vec3 base, vec3 n, float facing, float depth, float open, float y_ndc) {
  const vec3 key = vec3(-0.46, 0.62, 0.635);
  float direct = max(dot(n, key) * 0.87 + 0.13, 0.0);
  float sky = 0.62 + 0.38 * n.y;
  vec3 light = base * (0.56 * sky * open * vec3(0.94, 0.98, 1.08) + 0.78 * direct * (0.35 + 0.65 * open) * vec3(1.05, 1.0, 0.94));
  const vec3 half_way = vec3(-0.255, 0.343, 0.904);  // for an eye straight ahead
  float shine = max(dot(n, half_way), 0.0);
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
  light += 0.16 * shine * (0.3 + 0.7 * open);
  float rim = 1.0 - min(facing * 2.2, 1.0);
  light *= 1.0 - 0.72 * rim * rim;
  vec3 ground = mix(u_bottom, u_top, 0.5 + 0.5 * y_ndc);
  float fade = u_fade.z * clamp((depth - u_fade.x) * u_fade.y, 0.0, 1.0);
  light *= 1.10;
  return sqrt(mix(light, ground * ground, fade));
}
)";

void setLighting(const GlProgram& program, const Projection& projection, const Lighting& lighting) {
  glUniform3fv(program.uniform("u_top"), 1, &lighting.background_top.x);
  glUniform3fv(program.uniform("u_bottom"), 1, &lighting.background_bottom.x);
  glUniform3f(program.uniform("u_fade"), lighting.fade_from_A, 1.0f / lighting.fade_over_A, lighting.fade_most);
  glUniform2f(program.uniform("u_tan"), projection.tan_x, projection.tan_y);
  glUniform2f(program.uniform("u_depth"), projection.depthScale(), projection.depthOffset());
  glUniformMatrix3fv(program.uniform("u_turn"), 1, GL_FALSE, &lighting.rotation[0][0]);
}

}  // namespace moltact
