#include "engine/render/wireframe.h"

#include <algorithm>

#include "engine/render/molecule_model.h"

namespace moltact {
namespace {

const char* const kWireVertexText = R"(
layout(location = 0) in vec3 a_place;
layout(location = 1) in vec2 a_across;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in float a_hidden;
uniform float u_hidden;
out vec4 v_colour;
out vec2 v_across;
out float v_depth;
void main() {
  v_colour = vec4(a_colour.rgb, a_colour.a * mix(1.0, a_hidden, u_hidden));
  v_across = a_across;
  v_depth = a_place.z;
  gl_Position = vec4(a_place.xy, 0.0, 1.0);
}
)";

const char* const kWireFragmentText = R"(
in vec4 v_colour;
in vec2 v_across;
in float v_depth;
out vec4 o_colour;
void main() {
  gl_FragDepth = clamp(v_depth, 0.0, 1.0);
  o_colour = vec4(v_colour.rgb, v_colour.a * clamp(v_across.y + 0.5 - abs(v_across.x), 0.0, 1.0));
}
)";

}  // namespace

Expected<Wireframe> Wireframe::build() {
  Wireframe made;
  auto program = GlProgram::build("lines", kWireVertexText, kWireFragmentText);
  if (!program) return program.problem();
  made.program_ = *std::move(program);
  if (made.stream_->bind()) {
    GlStream::floats(0, 3, sizeof(Vertex), offsetof(Vertex, x));
    GlStream::floats(1, 2, sizeof(Vertex), offsetof(Vertex, across_px));
    GlStream::bytes4(2, sizeof(Vertex), offsetof(Vertex, colour));
    GlStream::floats(3, 1, sizeof(Vertex), offsetof(Vertex, hidden));
  }
  return {std::move(made)};
}

// Neighbouring quads share their mitred corners, so that a translucent line has no bright joints.
void Wireframe::pushPiece(std::span<const glm::vec3> ndc, const Strokes::Line& line, const Projection& projection,
                          float scale) {
  if (ndc.size() < 2) return;
  const glm::vec2 half(0.5f * float(projection.width_px), 0.5f * float(projection.height_px));
  const float half_px = 0.5f * std::max(line.stroke.width_px * scale, 0.5f), reach = half_px + 1.0f;
  const std::uint32_t colour = packColour(line.stroke.colour, line.stroke.alpha);
  const bool closed = glm::length(glm::vec2(ndc.front() - ndc.back()) * half) < 1e-2f && ndc.size() > 3;
  const auto direction = [&](std::size_t a, std::size_t b) {
    const glm::vec2 d = glm::vec2(ndc[b] - ndc[a]) * half;
    const float n = glm::length(d);
    return n > 1e-6f ? d / n : glm::vec2(0.0f);
  };
  Vertex before[2]{};
  for (std::size_t i = 0; i < ndc.size(); ++i) {
    const glm::vec2 in = i > 0    ? direction(i - 1, i)
                         : closed ? direction(ndc.size() - 2, ndc.size() - 1)
                                  : direction(0, 1);
    const glm::vec2 out = i + 1 < ndc.size() ? direction(i, i + 1) : closed ? direction(0, 1) : in;
    glm::vec2 along = in + out;
    const float n = glm::length(along);
    along = n > 1e-3f ? along / n : out;
    const float stretch = std::min(2.0f, 1.0f / std::max(0.3f, glm::dot(along, out)));
    const glm::vec2 offset = glm::vec2(-along.y, along.x) * (reach * stretch) / half;
    Vertex now[2];
    for (const int side : {0, 1}) {
      const float sign = side ? 1.0f : -1.0f;
      now[side] = {ndc[i].x + sign * offset.x, ndc[i].y + sign * offset.y, ndc[i].z, sign * reach, half_px, colour,
                   line.stroke.hidden};
    }
    if (i > 0) vertices_.insert(vertices_.end(), {before[0], before[1], now[0], now[1]});
    before[0] = now[0];
    before[1] = now[1];
  }
}

void Wireframe::draw(const Strokes& strokes, const Projection& projection, float scale) {
  vertices_.clear();
  const float near = float(projection.depth.near_A);
  for (const Strokes::Line& line : strokes.lines()) {
    // Parts in front of the near plane are clipped; such a line is divided into pieces.
    ndc_.clear();
    for (std::size_t i = line.begin; i < line.end; ++i) {
      const glm::vec3 p = strokes[i];
      const bool ahead = -p.z >= near;
      if (i > line.begin && ahead != (-strokes[i - 1].z >= near)) {
        const glm::vec3 q = strokes[i - 1];
        ndc_.push_back(projection.toNdc(glm::mix(q, p, (near * 1.0001f + q.z) / (q.z - p.z))));
      }
      if (ahead) {
        ndc_.push_back(projection.toNdc(p));
      } else {
        pushPiece(ndc_, line, projection, scale);
        ndc_.clear();
      }
    }
    pushPiece(ndc_, line, projection, scale);
  }
  if (vertices_.empty()) return;
  glUseProgram(program_.id());
  stream_->bind();
  stream_->upload(vertices_.data(), vertices_.size() * sizeof(Vertex));
  stream_->reserveQuads(vertices_.size() / 4);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  for (const bool hidden : {true, false}) {
    glDepthFunc(hidden ? GL_GREATER : GL_LEQUAL);
    glUniform1f(program_.uniform("u_hidden"), hidden ? 1.0f : 0.0f);
    glDrawElements(GL_TRIANGLES, GLsizei(vertices_.size() / 4 * 6), GL_UNSIGNED_INT, nullptr);
  }
}

}  // namespace moltact
