#include "engine/render/sphere_impostors.h"

#include <algorithm>

namespace moltact {
namespace {

const char* const kVertexText = R"(
layout(location = 0) in vec2 a_corner;
layout(location = 1) in vec4 a_sphere;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in vec4 a_ambient;
uniform vec2 u_tan;
uniform mat3 u_turn;
out vec3 v_ray;      // z is -1; x and y are linear over the picture
flat out vec4 v_sphere, v_colour, v_ambient;
out float v_y;
void main() {
  v_ray = vec3(a_corner * u_tan, -1.0);
  v_sphere = a_sphere;
  v_colour = a_colour;
  v_ambient = vec4(u_turn * a_ambient.xyz, a_ambient.w);
  v_y = a_corner.y;
  gl_Position = vec4(a_corner, 0.0, 1.0);
}
)";

// The distance of the ray from the centre is taken at the ray's nearest point and not as |centre|^2 - radius^2, which
// would lose the radius to rounding when the ball is far. The rim lies behind the ball's middle, so that balls that
// grow into each other have none between them; its normal is square to the ray, so it is shade.
const char* const kCutText = R"(
in vec3 v_ray;
flat in vec4 v_sphere, v_colour, v_ambient;
in float v_y;
uniform vec2 u_depth;
uniform float u_rim;
out vec4 o_colour;
float cut(out vec3 normal, out float facing) {
  float shorten = inversesqrt(dot(v_ray, v_ray));
  float nearest = dot(v_ray, v_sphere.xyz) * (shorten * shorten);
  vec3 aside = v_ray * nearest - v_sphere.xyz;
  float away = dot(aside, aside), reach = v_sphere.w + u_rim * nearest;
  if (away > reach * reach) discard;
  float left = v_sphere.w * v_sphere.w - away;
  float half_chord = sqrt(max(left, 0.0)), back = half_chord * shorten, by_radius = 1.0 / v_sphere.w;
  normal = (aside - v_ray * back) * by_radius;
  facing = half_chord * by_radius;
  float depth = left < 0.0 ? nearest + 0.75 * v_sphere.w : nearest - back;
  gl_FragDepth = clamp(u_depth.x - u_depth.y / depth, 0.0, 1.0);
  return depth;
}
)";

// Marked balls are striped, so that they are told from the others without seeing their colour.
const char* const kSolidText = R"(
void main() {
  vec3 n;
  float facing, depth = cut(n, facing);
  float open = clamp(v_ambient.w + dot(v_ambient.xyz, n), 0.0, 1.0);
  vec3 base = v_colour.rgb * v_colour.rgb;
  bool striped = v_colour.a > 0.994 && v_colour.a < 0.998;
  if (striped) {
    float wave = abs(fract((n.x + n.y) * 1.6) - 0.5), soft = fwidth(n.x + n.y) * 1.6;
    base *= mix(1.0, 0.13, smoothstep(0.30 - soft, 0.30 + soft, wave));
  }
  o_colour = vec4(lit(base, n, facing, depth, open, v_y), striped ? 1.0 : v_colour.a);
}
)";

constexpr float kStriped = 254.0f / 255.0f;  // an opacity that stands for stripes

const char* const kShellText = R"(
void main() {
  vec3 n;
  float facing;
  cut(n, facing);
  float away = 1.0 - facing;
  float glint = pow(max(dot(n, normalize(vec3(-0.46, 0.62, 1.4))), 0.0), 60.0);
  float rim = away * away;
  o_colour = vec4(v_colour.rgb + glint * 0.5, v_colour.a * clamp(0.10 + 0.9 * rim * away + 0.45 * glint, 0.0, 1.0));
}
)";

}  // namespace

Expected<SphereImpostors> SphereImpostors::build() {
  SphereImpostors made;
  auto solid = GlProgram::build("solid balls", kVertexText, std::string(kCutText) + kLightingText + kSolidText);
  if (!solid) return solid.problem();
  auto shell = GlProgram::build("bubbles", kVertexText, std::string(kCutText) + kShellText);
  if (!shell) return shell.problem();
  made.solid_ = *std::move(solid);
  made.shell_ = *std::move(shell);
  if (made.stream_->bind()) {
    GlStream::floats(0, 2, sizeof(Vertex), offsetof(Vertex, x));
    GlStream::floats(1, 4, sizeof(Vertex), offsetof(Vertex, centre_x));
    GlStream::bytes4(2, sizeof(Vertex), offsetof(Vertex, colour));
    GlStream::bytes4(3, sizeof(Vertex), offsetof(Vertex, ambient_occlusion), true);
  }
  return {std::move(made)};
}

void SphereImpostors::push(const DrawnSphere& s, std::uint32_t colour, std::uint32_t ambient_occlusion) {
  for (const glm::vec2 corner : {s.low, glm::vec2(s.high.x, s.low.y), glm::vec2(s.low.x, s.high.y), s.high})
    vertices_.push_back({corner.x, corner.y, s.centre.x, s.centre.y, s.centre.z, s.radius, colour, ambient_occlusion});
}

void SphereImpostors::flush(Pass pass, float rim, const Projection& projection, const Lighting& lighting) {
  if (vertices_.empty()) return;
  const GlProgram& program = pass == Pass::Shell ? shell_ : solid_;
  glUseProgram(program.id());
  setLighting(program, projection, lighting);
  glUniform1f(program.uniform("u_rim"), rim);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(pass == Pass::Ghost ? GL_GREATER : GL_LESS);
  glDepthMask(pass == Pass::Solid);
  pass == Pass::Solid ? glDisable(GL_BLEND) : glEnable(GL_BLEND);
  stream_->bind();
  stream_->upload(vertices_.data(), vertices_.size() * sizeof(Vertex));
  stream_->reserveQuads(vertices_.size() / 4);
  glDrawElements(GL_TRIANGLES, GLsizei(vertices_.size() / 4 * 6), GL_UNSIGNED_INT, nullptr);
  vertices_.clear();
}

void SphereImpostors::drawMolecule(const MoleculeModel& model, std::span<const DrawnSphere> spheres,
                                   std::span<const std::uint32_t> tinted, std::uint32_t tint, float rim,
                                   const Projection& projection, const Lighting& lighting) {
  const std::uint32_t striped = (tint & 0x00FFFFFFu) | packColour({}, kStriped);
  for (const DrawnSphere& s : spheres) {
    const bool is_tinted = std::binary_search(tinted.begin(), tinted.end(), s.index);
    push(s, is_tinted ? striped : model.colour[s.index], model.ambient_occlusion[s.index]);
  }
  flush(Pass::Solid, rim, projection, lighting);
}

void SphereImpostors::drawLoose(std::span<const LooseSphere> spheres, Pass pass, const Projection& projection,
                                const Lighting& lighting) {
  constexpr std::uint32_t kOpen = 127u << 24;
  for (const LooseSphere& s : spheres) {
    DrawnSphere drawn;
    if (projectSphere(projection, s.centre, s.radius, drawn)) push(drawn, s.colour, kOpen);
  }
  flush(pass, 0.0f, projection, lighting);
}

}  // namespace moltact
