#include "assets/generator/hand_models.h"

#include <cmath>
#include <numbers>

namespace moltact::generator {
namespace {

constexpr float kM_per_mm = 0.001f;

// A point on the outline of a solid of revolution about the y axis (unit: millimetre).
struct Outline {
  float y, r;
};

// Adds the band between two points of the outline, as a part with one material.
void addBand(GltfMesh& mesh, Outline a, Outline b, std::size_t material) {
  constexpr int kSides = 32;
  const float length = std::hypot(b.y - a.y, b.r - a.r), out = (b.y - a.y) / length, up = (a.r - b.r) / length;
  const auto first = std::uint32_t(mesh.places.size());
  for (int k = 0; k <= kSides; ++k) {
    const float t = 2 * std::numbers::pi_v<float> * float(k % kSides) / kSides, c = std::cos(t), s = std::sin(t);
    for (const Outline& p : {a, b}) {
      mesh.places.push_back(glm::vec3(p.r * s, p.y, p.r * c) * kM_per_mm);
      mesh.normals.push_back({out * s, up, out * c});
    }
  }
  while (mesh.parts.size() <= material) mesh.parts.push_back({.indices = {}, .material = mesh.parts.size()});
  auto& indices = mesh.parts[material].indices;
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const std::uint32_t i = first + 2 * k;
    indices.insert(indices.end(), {i, i + 2, i + 1, i + 1, i + 2, i + 3});
  }
}

}  // namespace

GltfScene makeStylus() {
  enum : std::size_t { kTip, kRing, kBarrel };
  GltfScene scene;
  scene.title = "stylus";
  scene.notes = {{"unit", "1 m"}};
  scene.materials = {
      {"tip", {0.30f, 0.33f, 0.38f}}, {"ring", {0.06f, 0.55f, 0.52f}}, {"barrel", {0.86f, 0.88f, 0.91f}}};
  GltfMesh mesh{.name = "stylus", .places = {}, .normals = {}, .parts = {}};
  constexpr float kSphere_mm = 1.2f;
  constexpr int kArc = 6;
  const auto arc = [&](int k) {
    const float t = 0.5f * std::numbers::pi_v<float> * float(k) / kArc;
    return Outline{kSphere_mm * (1 - std::cos(t)), kSphere_mm * std::sin(t)};
  };
  for (int k = 0; k < kArc; ++k) addBand(mesh, arc(k), arc(k + 1), kTip);
  addBand(mesh, {kSphere_mm, kSphere_mm}, {24, 4.6f}, kTip);
  addBand(mesh, {24, 4.6f}, {24.6f, 5.4f}, kRing);
  addBand(mesh, {24.6f, 5.4f}, {29, 5.4f}, kRing);
  addBand(mesh, {29, 5.4f}, {29.6f, 5.0f}, kRing);
  addBand(mesh, {29.6f, 5.0f}, {102, 6.2f}, kBarrel);
  addBand(mesh, {102, 6.2f}, {107, 5.2f}, kBarrel);
  addBand(mesh, {107, 5.2f}, {110, 2.6f}, kBarrel);
  addBand(mesh, {110, 2.6f}, {110.6f, 0}, kBarrel);
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({.name = "stylus", .mesh = 0});
  return scene;
}

}  // namespace moltact::generator
