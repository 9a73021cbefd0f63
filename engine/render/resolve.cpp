#include "engine/render/resolve.h"

namespace moltact {

const char* const kWholePictureText = R"(
out vec2 v_uv;
void main() {
  v_uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(v_uv * 2.0 - 1.0, 0.0, 1.0);
}
)";

namespace {

// Noise of half a level hides the bands of a dark gradient.
const char* const kBackgroundText = R"(
in vec2 v_uv;
uniform vec3 u_top, u_bottom;
out vec4 o_colour;
void main() {
  float noise = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) - 0.5;
  o_colour = vec4(mix(u_bottom, u_top, v_uv.y) + noise / 255.0, 1.0);
}
)";

const char* const kLayerText = R"(
in vec2 v_uv;
uniform sampler2D u_colour;
uniform int u_samples;
out vec4 o_colour;
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * u_samples;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < u_samples; ++y)
    for (int x = 0; x < u_samples; ++x) sum += texelFetch(u_colour, first + ivec2(x, y), 0).rgb;
  o_colour = vec4(sum / float(u_samples * u_samples), 1.0);
}
)";

}  // namespace

void copyPart(const GlTarget& from, const GlTarget& to, const PixelBox& part, GLbitfield what) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer());
  glBlitFramebuffer(part.x0, part.y0, part.x1, part.y1, part.x0, part.y0, part.x1, part.y1, what, GL_NEAREST);
}

Expected<Resolve> Resolve::build() {
  Resolve made;
  auto background = GlProgram::build("background", kWholePictureText, kBackgroundText);
  if (!background) return background.problem();
  auto layer = GlProgram::build("layer", kWholePictureText, kLayerText);
  if (!layer) return layer.problem();
  made.background_ = *std::move(background);
  made.layer_ = *std::move(layer);
  return {std::move(made)};
}

void Resolve::background(const Lighting& lighting) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glUseProgram(background_.id());
  glUniform3fv(background_.uniform("u_top"), 1, &lighting.background_top.x);
  glUniform3fv(background_.uniform("u_bottom"), 1, &lighting.background_bottom.x);
  stream_->bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Resolve::layer(const GlTarget& from, int samples) {
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDisable(GL_BLEND);
  glUseProgram(layer_.id());
  glUniform1i(layer_.uniform("u_colour"), 0);
  glUniform1i(layer_.uniform("u_samples"), samples);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, from.colour());
  stream_->bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace moltact
