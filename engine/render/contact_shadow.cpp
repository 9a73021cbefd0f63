#include "engine/render/contact_shadow.h"

#include "engine/render/lighting.h"
#include "engine/render/resolve.h"

namespace moltact {
namespace {

// Near the sphere, the fraction of the sky that it covers, (radius / distance)^2; along the light, its projection,
// whose edge softens with distance. Nothing is darkened beyond kReach.
const char* const kShadowFragmentText = R"(
in vec2 v_uv;
uniform sampler2D u_window;
uniform vec2 u_tan, u_depth;
uniform vec4 u_ball;
uniform vec3 u_key;
out vec4 o_colour;
void main() {
  float window = texelFetch(u_window, ivec2(gl_FragCoord.xy), 0).r;
  if (window >= 1.0) discard;
  float depth = u_depth.y / (u_depth.x - window);
  vec3 to_ball = u_ball.xyz - vec3((v_uv * 2.0 - 1.0) * u_tan, -1.0) * depth;
  float way2 = dot(to_ball, to_ball), r2 = u_ball.w * u_ball.w;
  float covered = clamp(r2 / max(way2, r2), 0.0, 1.0);
  float near = covered * covered * sqrt(covered);
  float along = dot(to_ball, u_key);
  float aside = sqrt(max(way2 - along * along, 0.0)) / u_ball.w, soft = clamp(0.25 + 0.18 * along / u_ball.w, 0.1, 1.2);
  float thrown = (1.0 - smoothstep(1.0 - soft, 1.0 + 0.6 * soft, aside)) * smoothstep(0.0, 0.8, along / u_ball.w) *
                 (1.0 - smoothstep(1.5, kReach, along / u_ball.w));
  float dark = 1.0 - (1.0 - 0.62 * near) * (1.0 - 0.48 * thrown);
  o_colour = vec4(0.0, 0.0, 0.02, dark * (1.0 - smoothstep(0.8 * kReach, kReach, sqrt(way2) / u_ball.w)));
}
)";

}  // namespace

Expected<ContactShadow> ContactShadow::build() {
  const std::string reach = "const float kReach = " + std::to_string(int(kReach * 10)) + ".0 / 10.0;\n";
  auto program = GlProgram::build("contact shadow", kWholePictureText, reach + kShadowFragmentText);
  if (!program) return program.problem();
  ContactShadow made;
  made.program_ = *std::move(program);
  return {std::move(made)};
}

void ContactShadow::draw(const GlTarget& drawn, const glm::vec3& centre, float radius, const Projection& projection) {
  if (!(radius > 0)) return;
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glUseProgram(program_.id());
  glUniform1i(program_.uniform("u_window"), 0);
  glUniform2f(program_.uniform("u_tan"), projection.tan_x, projection.tan_y);
  glUniform2f(program_.uniform("u_depth"), projection.depthScale(), projection.depthOffset());
  glUniform4f(program_.uniform("u_ball"), centre.x, centre.y, centre.z, radius);
  glUniform3fv(program_.uniform("u_key"), 1, &kKeyLight.x);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, drawn.depth());
  stream_->bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace moltact
