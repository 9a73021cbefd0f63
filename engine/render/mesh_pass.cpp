#include "engine/render/mesh_pass.h"

namespace moltact {
namespace {

// The depth in the window is linear in 1 / depth, like that of the spheres, so the card's interpolation is exact.
const char* const kMeshVertexText = R"(
layout(location = 0) in vec3 a_place;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_colour;
uniform mat4 u_to_view;
uniform vec2 u_tan, u_depth;
out vec3 v_place, v_normal;
out vec4 v_colour;
void main() {
  v_place = (u_to_view * vec4(a_place, 1.0)).xyz;
  v_normal = mat3(u_to_view) * a_normal;
  v_colour = a_colour;
  float d = -v_place.z;
  gl_Position = vec4(v_place.xy / u_tan, (2.0 * u_depth.x - 1.0) * d - 2.0 * u_depth.y, d);
}
)";

// Inner walls are darker. In a cut, the inside is drawn flat and darker, as if it were filled: a wall seen from behind
// has only the solid in front of it.
const char* const kMeshFragmentText = R"(
in vec3 v_place, v_normal;
in vec4 v_colour;
uniform vec2 u_tan;
uniform float u_opacity;
out vec4 o_colour;
void main() {
  if (cutAway(v_place)) discard;
  vec3 n = normalize(v_normal), eye = -normalize(v_place);
  float facing = dot(n, eye);
  vec3 base = v_colour.rgb * v_colour.rgb;
  if (facing < 0.0) {
    n = -n;
    facing = -facing;
    if (!gl_FrontFacing && dot(u_cut.xyz, u_cut.xyz) > 0.0) {
      o_colour = vec4(v_colour.rgb * CAP_SHADE, u_opacity);
      return;
    }
    if (!gl_FrontFacing) base *= 0.45;
  }
  float y = clamp(v_place.y / (-v_place.z * u_tan.y), -1.0, 1.0);
  o_colour = vec4(lit(base, v_place, n, facing, y), u_opacity);
}
)";

}  // namespace

GpuMesh::GpuMesh(const MeshPiece& piece) : indices_(piece.indices.size()), origin_A_(piece.origin_A) {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &elements_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  using Vertex = MeshPiece::Vertex;
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(piece.vertices.size() * sizeof(Vertex)), piece.vertices.data(),
               GL_STATIC_DRAW);
  GlStream::floats(0, 3, sizeof(Vertex), offsetof(Vertex, place));
  GlStream::floats(1, 3, sizeof(Vertex), offsetof(Vertex, normal));
  GlStream::bytes4(2, sizeof(Vertex), offsetof(Vertex, colour));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(piece.indices.size() * sizeof(std::uint32_t)), piece.indices.data(),
               GL_STATIC_DRAW);
}

GpuMesh::~GpuMesh() {
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &elements_);
}

void GpuMesh::draw() const {
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, GLsizei(indices_), GL_UNSIGNED_INT, nullptr);
}

Expected<MeshPass> MeshPass::build() {
  auto program = GlProgram::build("meshes", kMeshVertexText, kLightingText + kMeshFragmentText);
  if (!program) return program.problem();
  MeshPass made;
  made.program_ = *std::move(program);
  return {std::move(made)};
}

void MeshPass::draw(const GpuMesh& mesh, float opacity, const Projection& projection, const Lighting& lighting) const {
  if (mesh.triangles() == 0) return;
  glUseProgram(program_.id());
  setLighting(program_, projection, lighting);
  const glm::mat3 turn(glm::transpose(glm::mat3_cast(lighting.camera.orientation)));
  glm::mat4 to_view(turn);
  to_view[3] = glm::vec4(glm::vec3(lighting.camera.toView({mesh.origin_A()})), 1.0f);
  glUniformMatrix4fv(program_.uniform("u_to_view"), 1, GL_FALSE, &to_view[0][0]);
  glUniform1f(program_.uniform("u_opacity"), opacity);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  if (opacity < 1.0f) {  // first the depth of the nearest wall alone
    glDepthFunc(GL_LESS);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    mesh.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    glDepthFunc(GL_LEQUAL);
  } else {
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
  }
  mesh.draw();
}

}  // namespace moltact
