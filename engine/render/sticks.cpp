#include "engine/render/sticks.h"

#include <cmath>

#include "engine/core/sphere_intersections.h"
#include "engine/core/units.h"

namespace moltact {

void addStick(MeshPiece& piece, const Vec3& a, const Vec3& b, double radius_A, std::uint32_t colour, bool closed) {
  const double length = glm::length(b - a);
  if (!(length > 1e-6)) return;
  const Vec3 axis = (b - a) / length, u = anyNormal(axis), v = glm::cross(axis, u);
  const int sides = radius_A < 0.12 ? 5 : 10;
  const auto first = std::uint32_t(piece.vertices.size());
  const auto count = std::uint32_t(sides);
  for (int k = 0; k < sides; ++k) {
    const double t = kTwoPi * k / sides;
    const Vec3 out = std::cos(t) * u + std::sin(t) * v;
    for (const Vec3& end : {a, b})
      piece.vertices.push_back({glm::vec3(end + out * radius_A - piece.origin_A), glm::vec3(out), colour});
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t a0 = first + 2 * k, a1 = first + 2 * ((k + 1) % count);
    piece.triangle(a0, a1, a0 + 1);
    piece.triangle(a0 + 1, a1, a1 + 1);
  }
  if (!closed) return;
  for (const std::uint32_t end : {0u, 1u}) {
    const auto lid = std::uint32_t(piece.vertices.size());
    for (std::uint32_t k = 0; k < count; ++k) {
      MeshPiece::Vertex corner = piece.vertices[first + 2 * k + end];
      corner.normal = glm::vec3(end ? axis : -axis);
      piece.vertices.push_back(corner);
    }
    for (std::uint32_t k = 1; k + 1 < count; ++k)
      end ? piece.triangle(lid, lid + k, lid + k + 1) : piece.triangle(lid, lid + k + 1, lid + k);
  }
}

MeshPiece sticks(const Molecule& molecule, std::span<const Bond> bonds, std::span<const std::uint8_t> drawn,
                 std::span<const std::uint32_t> colours, double radius_A) {
  MeshPiece piece;
  if (molecule.atoms.empty()) return piece;
  piece.origin_A = molecule.spheres[0].centre_A;
  for (const Bond& bond : bonds) {
    if (!drawn[bond.first] || !drawn[bond.second]) continue;
    const Vec3 a = molecule.spheres[bond.first].centre_A, b = molecule.spheres[bond.second].centre_A;
    if (colours[bond.first] == colours[bond.second]) {
      addStick(piece, a, b, radius_A, colours[bond.first], false);
      continue;
    }
    const Vec3 middle = 0.5 * (a + b);
    addStick(piece, a, middle, radius_A, colours[bond.first], false);
    addStick(piece, middle, b, radius_A, colours[bond.second], false);
  }
  return piece;
}

}  // namespace moltact
