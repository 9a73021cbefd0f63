#include "engine/render/sphere_impostors.h"

#include <algorithm>

namespace moltact {
namespace {

const char* const kSphereVertexText = R"(
layout(location = 0) in vec2 a_corner;
layout(location = 1) in vec4 a_sphere;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in vec4 a_wide;
uniform vec2 u_tan;
out vec3 v_ray;      // z is -1; x and y are linear over the picture
flat out vec4 v_sphere, v_colour, v_wide;
out float v_y;
void main() {
  v_wide = a_wide - vec4(0.5, 0.5, 0.5, 0.0);
  v_ray = vec3(a_corner * u_tan, -1.0);
  v_sphere = a_sphere;
  v_colour = a_colour;
  v_y = a_corner.y;
  gl_Position = vec4(a_corner, 0.0, 1.0);
}
)";

// The ray's distance from the centre is computed at the ray's nearest point. The difference |centre|^2 - radius^2 would
// lose the radius to rounding for a distant sphere. The rim lies behind the sphere's middle, so that overlapping
// spheres have none between them; its normal is perpendicular to the ray, so it is dark.
const char* const kRayText = R"(
in vec3 v_ray;
flat in vec4 v_sphere, v_colour, v_wide;
in float v_y;
uniform vec2 u_depth;
uniform float u_rim;
out vec4 o_colour;
float entry(out vec3 normal, out float facing, out float leave) {
  float shorten = inversesqrt(dot(v_ray, v_ray));
  float nearest = dot(v_ray, v_sphere.xyz) * (shorten * shorten);
  vec3 aside = v_ray * nearest - v_sphere.xyz;
  float away = dot(aside, aside), reach = v_sphere.w + u_rim * nearest;
  if (away > reach * reach) discard;
  float left = v_sphere.w * v_sphere.w - away;
  float half_chord = sqrt(max(left, 0.0)), back = half_chord * shorten, by_radius = 1.0 / v_sphere.w;
  normal = (aside - v_ray * back) * by_radius;
  facing = half_chord * by_radius;
  leave = nearest + back;
  return left < 0.0 ? nearest + 0.75 * v_sphere.w : nearest - back;
}
void writeDepth(float depth) { gl_FragDepth = clamp(u_depth.x - u_depth.y / depth, 0.0, 1.0); }
)";

// A sphere that the cut intersects shows a flat face. Marked spheres have a dark ring toward the viewer, like a target,
// which distinguishes them without colour.
const char* const kSolidText = R"(
void main() {
  vec3 n;
  float facing, leave, depth = entry(n, facing, leave);
  bool capped = false;
  // A sphere intersected by the plane has no rim.
  if (facing == 0.0 && dot(u_cut.xyz, v_sphere.xyz) + u_cut.w > -v_sphere.w) discard;
  if (cutAway(v_ray * depth)) {
    float at = -u_cut.w / dot(u_cut.xyz, v_ray);
    if (!(at > depth && at < leave)) discard;
    depth = at;
    n = u_cut.xyz;
    capped = true;
  }
  writeDepth(depth);
  wide_filled = v_wide.w + dot(v_wide.xyz, n);
  vec3 base = v_colour.rgb * v_colour.rgb;
  if (capped) {  // flat and darker, to distinguish the face of the cut
    o_colour = vec4(v_colour.rgb * CAP_SHADE, v_colour.a);
    return;
  }
  bool marked = v_colour.a > 0.994 && v_colour.a < 0.998;
  if (marked) base *= 1.0 - 0.87 * smoothstep(0.64, 0.68, facing) * (1.0 - smoothstep(0.84, 0.87, facing));
  o_colour = vec4(lit(base, v_ray * depth, n, facing, v_y), marked ? 1.0 : v_colour.a);
}
)";

constexpr float kMarked = 254.0f / 255.0f;  // an opacity that encodes the ring of a target

const char* const kShellText = R"(
void main() {
  vec3 n;
  float facing, leave;
  writeDepth(entry(n, facing, leave));
  float away = 1.0 - facing;
  float glint = pow(max(dot(n, normalize(vec3(-0.46, 0.62, 1.4))), 0.0), 60.0);
  float rim = away * away;
  o_colour = vec4(v_colour.rgb + glint * 0.5, v_colour.a * clamp(0.10 + 0.9 * rim * away + 0.45 * glint, 0.0, 1.0));
}
)";

// Packs a value in the camera's axes into bytes.
std::uint32_t packWide(const glm::vec4& round, const glm::mat3& to_camera) {
  return packColour(to_camera * glm::vec3(round) + 0.5f, round.w);
}

}  // namespace

Expected<SphereImpostors> SphereImpostors::build() {
  SphereImpostors made;
  // Software renderers evaluate unused branches, so unoccluded spheres have a program of their own.
  const auto solidText = [](const char* define) {
    return std::string("#define ") + define + "\n" + kRayText + kLightingText + kSolidText;
  };
  auto solid = GlProgram::build("solid balls", kSphereVertexText, solidText("WIDE_GIVEN"));
  if (!solid) return solid.problem();
  auto even = GlProgram::build("balls in a hurry", kSphereVertexText, solidText("FINE_EVEN\n#define WIDE_GIVEN"));
  if (!even) return even.problem();
  auto open = GlProgram::build("balls in the open", kSphereVertexText, solidText("OPEN"));
  if (!open) return open.problem();
  auto shell = GlProgram::build("bubbles", kSphereVertexText, std::string(kRayText) + kShellText);
  if (!shell) return shell.problem();
  made.solid_ = *std::move(solid);
  made.even_ = *std::move(even);
  made.open_ = *std::move(open);
  made.shell_ = *std::move(shell);
  if (made.stream_->bind()) {
    GlStream::floats(0, 2, sizeof(Vertex), offsetof(Vertex, x));
    GlStream::floats(1, 4, sizeof(Vertex), offsetof(Vertex, centre_x));
    GlStream::bytes4(2, sizeof(Vertex), offsetof(Vertex, colour));
    GlStream::bytes4(3, sizeof(Vertex), offsetof(Vertex, wide));
  }
  return {std::move(made)};
}

void SphereImpostors::push(const DrawnSphere& s, std::uint32_t colour, std::uint32_t wide) {
  for (const glm::vec2 corner : {s.low, glm::vec2(s.high.x, s.low.y), glm::vec2(s.low.x, s.high.y), s.high})
    vertices_.push_back({corner.x, corner.y, s.centre.x, s.centre.y, s.centre.z, s.radius, colour, wide});
}

void SphereImpostors::flush(Pass pass, float rim, const Projection& projection, const Lighting& lighting) {
  if (vertices_.empty()) return;
  const GlProgram& program = pass == Pass::Shell   ? shell_
                             : !lighting.occlusion ? open_
                             : lighting.fine       ? solid_
                                                   : even_;
  glUseProgram(program.id());
  setLighting(program, projection, lighting);
  glUniform1f(program.uniform("u_rim"), rim);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(pass == Pass::Ghost ? GL_GREATER : GL_LESS);
  glDepthMask(pass == Pass::Solid || pass == Pass::Faint);
  pass == Pass::Solid ? glDisable(GL_BLEND) : glEnable(GL_BLEND);
  stream_->bind();
  stream_->upload(vertices_.data(), vertices_.size() * sizeof(Vertex));
  stream_->reserveQuads(vertices_.size() / 4);
  glDrawElements(GL_TRIANGLES, GLsizei(vertices_.size() / 4 * 6), GL_UNSIGNED_INT, nullptr);
  vertices_.clear();
}

void SphereImpostors::drawMolecule(const MoleculeModel& model, std::span<const DrawnSphere> spheres,
                                   std::span<const std::uint32_t> tinted, std::uint32_t tint, float rim, float opacity,
                                   const Projection& projection, const Lighting& lighting) {
  const std::uint32_t marked = (tint & 0x00FFFFFFu) | packColour({}, kMarked);
  const std::uint32_t alpha = packColour({}, opacity) & 0xFF000000u;
  const glm::mat3 to_camera(glm::transpose(glm::mat3_cast(lighting.camera.orientation)));
  for (const DrawnSphere& s : spheres) {
    const bool is_tinted = std::binary_search(tinted.begin(), tinted.end(), s.index);
    push(s, is_tinted ? marked : (model.colour[s.index] & 0x00FFFFFFu) | alpha,
         model.light.wide.empty() ? 0u : packWide(model.light.wide[s.index], to_camera));
  }
  flush(opacity < 1.0f ? Pass::Faint : Pass::Solid, rim, projection, lighting);
}

void SphereImpostors::drawLoose(std::span<const LooseSphere> spheres, Pass pass, const Projection& projection,
                                const Lighting& lighting) {
  const glm::mat3 to_camera(glm::transpose(glm::mat3_cast(lighting.camera.orientation)));
  for (const LooseSphere& s : spheres) {
    DrawnSphere drawn;
    if (projectSphere(projection, s.centre, s.radius, drawn)) push(drawn, s.colour, packWide(s.wide, to_camera));
  }
  flush(pass, 0.0f, projection, lighting);
}

}  // namespace moltact
