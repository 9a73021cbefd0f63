#include "engine/render/solid_mesh.h"

#include <array>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gltf/gltf_file.h"

namespace moltact {
namespace {

const char* const kSolidVertexText = R"(
layout(location = 0) in vec3 a_place;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_colour;
uniform vec2 u_tan;
out vec3 v_place, v_normal;
out vec4 v_colour;
out float v_y;
void main() {
  v_place = a_place;
  v_normal = a_normal;
  v_colour = a_colour;
  float d = -a_place.z;
  v_y = a_place.y / (max(d, 1e-4) * u_tan.y);
  gl_Position = vec4(a_place.xy / u_tan, 0.0, d);
}
)";

// The depth is written per pixel and not per vertex, so that parts in front of the near plane or behind the far plane
// are not clipped.
const char* const kSolidFragmentText = R"(
in vec3 v_place, v_normal;
in vec4 v_colour;
in float v_y;
uniform float u_alpha;
uniform vec2 u_depth;
out vec4 o_colour;
void main() {
  gl_FragDepth = clamp(u_depth.x + u_depth.y / v_place.z, 0.0, 1.0);
  vec3 n = normalize(v_normal);
  float facing = max(-dot(n, normalize(v_place)), 0.0);
  o_colour = vec4(lit(v_colour.rgb * v_colour.rgb, v_place, n, facing, clamp(v_y, -1.0, 1.0)), u_alpha);
}
)";

}  // namespace

Expected<SolidMesh> SolidMesh::build() {
  SolidMesh made;
  auto program = GlProgram::build("solid glyphs", kSolidVertexText, std::string(kLightingText) + kSolidFragmentText);
  if (!program) return program.problem();
  made.program_ = *std::move(program);
  if (made.stream_->bind()) {
    GlStream::floats(0, 3, sizeof(Vertex), offsetof(Vertex, place));
    GlStream::floats(1, 3, sizeof(Vertex), offsetof(Vertex, normal));
    GlStream::bytes4(2, sizeof(Vertex), offsetof(Vertex, colour));
  }
  return {std::move(made)};
}

void SolidMesh::addCone(const glm::vec3& a, const glm::vec3& b, float radius_a, float radius_b, std::uint32_t colour) {
  const float length = glm::length(b - a);
  if (!(length > 0)) return;
  const glm::vec3 axis = (b - a) / length;
  const glm::vec3 u =
      glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
  const glm::vec3 v = glm::cross(axis, u);
  const float rise = (radius_a - radius_b) / length;
  constexpr int kSides = 28;
  for (int i = 0; i < kSides; ++i) {
    std::array<glm::vec3, 2> radial;
    for (const int k : {0, 1}) {
      const float t = float(kTwoPi) * float(i + k) / kSides;
      radial[k] = std::cos(t) * u + std::sin(t) * v;
    }
    const glm::vec3 n0 = glm::normalize(radial[0] + rise * axis), n1 = glm::normalize(radial[1] + rise * axis);
    const Vertex a0{a + radius_a * radial[0], n0, colour}, a1{a + radius_a * radial[1], n1, colour};
    const Vertex b0{b + radius_b * radial[0], n0, colour}, b1{b + radius_b * radial[1], n1, colour};
    vertices_.insert(vertices_.end(), {a0, a1, b0, b0, a1, b1});
    vertices_.insert(vertices_.end(), {{a, -axis, colour}, {a1.place, -axis, colour}, {a0.place, -axis, colour}});
  }
}

void SolidMesh::addModel(const SolidModel& model, const glm::mat4& to_view) {
  const glm::mat3 turn(to_view);
  vertices_.reserve(vertices_.size() + model.corners.size());
  for (const SolidModel::Corner& c : model.corners)
    vertices_.push_back({glm::vec3(to_view * glm::vec4(c.place, 1.0f)), turn * c.normal, packColour(c.colour)});
}

void SolidMesh::draw(const Projection& projection, const Lighting& lighting, float ghost) {
  if (vertices_.empty()) return;
  glUseProgram(program_.id());
  setLighting(program_, projection, lighting);
  stream_->bind();
  stream_->upload(vertices_.data(), vertices_.size() * sizeof(Vertex));
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  for (const bool hidden : {true, false}) {
    if (hidden && ghost <= 0) continue;
    glDepthFunc(hidden ? GL_GREATER : GL_LESS);
    glDepthMask(!hidden);
    glUniform1f(program_.uniform("u_alpha"), hidden ? ghost : 1.0f);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices_.size()));
  }
  vertices_.clear();
}

}  // namespace moltact
