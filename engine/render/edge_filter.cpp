#include "engine/render/edge_filter.h"

#include "engine/render/resolve.h"

namespace moltact {
namespace {

const char* const kEdgeFragmentText = R"(
in vec2 v_uv;
uniform sampler2D u_colour;
uniform vec2 u_pixel;
out vec4 o_colour;
float bright(vec3 c) { return dot(c, vec3(0.30, 0.59, 0.11)); }
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(u_colour, 0) - 1;
  vec3 here = texelFetch(u_colour, at, 0).rgb;
  float m = bright(here);
  float nw = bright(texelFetch(u_colour, clamp(at + ivec2(-1, 1), ivec2(0), last), 0).rgb);
  float ne = bright(texelFetch(u_colour, clamp(at + ivec2(1, 1), ivec2(0), last), 0).rgb);
  float sw = bright(texelFetch(u_colour, clamp(at + ivec2(-1, -1), ivec2(0), last), 0).rgb);
  float se = bright(texelFetch(u_colour, clamp(at + ivec2(1, -1), ivec2(0), last), 0).rgb);
  float least = min(m, min(min(nw, ne), min(sw, se))), most = max(m, max(max(nw, ne), max(sw, se)));
  o_colour = vec4(here, 1.0);
  if (most - least < max(0.04, 0.10 * most)) return;
  vec2 way = vec2((sw + se) - (nw + ne), (ne + se) - (nw + sw));
  float small = 1.0 / (min(abs(way.x), abs(way.y)) + max((nw + ne + sw + se) * 0.03125, 0.008));
  way = clamp(vec2(way.x, way.y) * small, -8.0, 8.0) * u_pixel;
  vec3 two = 0.5 * (textureLod(u_colour, v_uv + way * (1.0 / 3.0 - 0.5), 0.0).rgb +
                    textureLod(u_colour, v_uv + way * (2.0 / 3.0 - 0.5), 0.0).rgb);
  vec3 four = 0.5 * two + 0.25 * (textureLod(u_colour, v_uv - 0.5 * way, 0.0).rgb +
                                  textureLod(u_colour, v_uv + 0.5 * way, 0.0).rgb);
  float b = bright(four);
  o_colour = vec4(b < least || b > most ? two : four, 1.0);
}
)";

}  // namespace

Expected<EdgeFilter> EdgeFilter::build() {
  auto program = GlProgram::build("smooth edges", kWholePictureText, kEdgeFragmentText);
  if (!program) return program.problem();
  EdgeFilter made;
  made.program_ = *std::move(program);
  return {std::move(made)};
}

void EdgeFilter::draw(const GlTarget& from) {
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDisable(GL_BLEND);
  glUseProgram(program_.id());
  glUniform1i(program_.uniform("u_colour"), 0);
  glUniform2f(program_.uniform("u_pixel"), 1.0f / float(from.width()), 1.0f / float(from.height()));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, from.colour());
  stream_->bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace moltact
