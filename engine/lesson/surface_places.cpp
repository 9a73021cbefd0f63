#include "engine/lesson/surface_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/even_directions.h"
#include "engine/core/saturated.h"
#include "engine/core/sphere_intersections.h"
#include "engine/core/units.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kOnSphere_A = 1e-7;  // rounding error of a place computed on a sphere

bool covered(const SphereGrid& scene, const Vec3& place, double probe_A, const std::array<std::int32_t, 3>& but) {
  bool found = false;
  scene.visitNear(place, probe_A, [&](std::uint32_t i, const Sphere& b) {
    const auto atom = static_cast<std::int32_t>(i);
    if (atom == but[0] || atom == but[1] || atom == but[2]) return true;
    found = glm::distance(place, b.centre_A) < b.radius_A + probe_A - kOnSphere_A;
    return !found;
  });
  return found;
}

// Whether a single atom covers the whole crease. With a large probe this is true of most creases, which can then be
// skipped.
bool coveredByOne(const SphereGrid& scene, const SphereCircle& crease, double probe_A, std::uint32_t a,
                  std::uint32_t b) {
  bool found = false;
  // An atom that covers the circle also covers its centre.
  scene.visitNear(crease.centre_A, probe_A, [&](std::uint32_t i, const Sphere& sphere) {
    if (i == a || i == b) return true;
    const Vec3 off = crease.centre_A - sphere.centre_A;
    const double along = glm::dot(off, crease.axis), aside = glm::length(off - crease.axis * along),
                 farthest_A = std::hypot(along, aside + crease.radius_A);
    found = farthest_A < sphere.radius_A + probe_A - kOnSphere_A;
    return !found;
  });
  return found;
}

// A unit vector perpendicular to `u`.
Vec3 across(const Vec3& u) {
  const Vec3 other = std::abs(u.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(glm::cross(u, other));
}

// Calls visit(a, b, crease), a < b, for each pair of these atoms whose grown spheres intersect, unless a single atom
// covers the whole circle.
template <class Visit>
void visitPairs(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A, Visit&& visit) {
  std::vector<char> in(scene.size(), 0);
  for (const std::uint32_t a : atoms) in[a] = scene.touchable(a);
  for (const std::uint32_t a : atoms) {
    if (!scene.touchable(a)) continue;
    scene.visitNear(scene[a].centre_A, scene[a].radius_A + 2.0 * probe_A, [&](std::uint32_t b, const Sphere&) {
      if (b <= a || !in[b]) return;
      const auto crease = circleOf(inflated(scene[a], probe_A), inflated(scene[b], probe_A));
      if (crease && !coveredByOne(scene, *crease, probe_A, a, b)) visit(a, b, *crease);
    });
  }
}

}  // namespace

std::vector<SurfacePlace> facePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                     int directions) {
  std::vector<SurfacePlace> out;
  for (const std::uint32_t a : atoms) {
    if (!scene.touchable(a)) continue;
    for (int k = 0; k < directions; ++k) {
      const Vec3 u = evenDirection(k, directions);
      SurfacePlace place{scene[a].centre_A + u * (scene[a].radius_A + probe_A),
                         u,
                         {static_cast<std::int32_t>(a), -1, -1},
                         Feature::Sphere};
      if (!covered(scene, place.scp_A, probe_A, place.atoms)) out.push_back(place);
    }
  }
  return out;
}

std::vector<SurfacePlace> creasePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                       double spacing_A) {
  std::vector<SurfacePlace> out;
  visitPairs(scene, atoms, probe_A, [&](std::uint32_t a, std::uint32_t b, const SphereCircle& crease) {
    const Vec3 x = across(crease.axis), y = glm::cross(crease.axis, x);
    // If one atom lies deep inside the other, such as a hydrogen, the circle is not between their centres. A push along
    // its radius would slide off; a push between the outward directions of both is held.
    const bool beside = glm::dot(crease.centre_A - scene[a].centre_A, crease.centre_A - scene[b].centre_A) > 0.0;
    const int count =
        std::clamp(saturateToInteger<int>(std::ceil(kTwoPi * crease.radius_A / spacing_A)), 12, kMaxCreasePlaces);
    for (int k = 0; k < count; ++k) {
      const double turn = kTwoPi * k / count;
      const Vec3 u = x * std::cos(turn) + y * std::sin(turn), at = crease.centre_A + u * crease.radius_A;
      SurfacePlace place{
          at,
          beside ? glm::normalize(glm::normalize(at - scene[a].centre_A) + glm::normalize(at - scene[b].centre_A)) : u,
          {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), -1},
          Feature::Circle};
      if (!covered(scene, place.scp_A, probe_A, place.atoms)) out.push_back(place);
    }
  });
  return out;
}

std::vector<SurfacePlace> pitPlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A) {
  std::vector<SurfacePlace> out;
  std::vector<char> in(scene.size(), 0);
  for (const std::uint32_t a : atoms) in[a] = 1;
  visitPairs(scene, atoms, probe_A, [&](std::uint32_t a, std::uint32_t b, const SphereCircle& crease) {
    scene.visitNear(crease.centre_A, crease.radius_A + probe_A, [&](std::uint32_t c, const Sphere& third) {
      if (c <= b || !in[c]) return;
      const auto points = pointsOf(inflated(scene[a], probe_A), inflated(scene[b], probe_A), inflated(third, probe_A));
      if (!points) return;
      for (const Vec3& place : {(*points)[1], (*points)[0]}) {
        const std::array<std::int32_t, 3> by{static_cast<std::int32_t>(a), static_cast<std::int32_t>(b),
                                             static_cast<std::int32_t>(c)};
        Vec3 outward(0.0);
        for (const std::int32_t atom : by)
          outward += glm::normalize(place - scene[static_cast<std::size_t>(atom)].centre_A);
        if (glm::length(outward) > 1e-6 && !covered(scene, place, probe_A, by))
          out.push_back({place, glm::normalize(outward), by, Feature::Point});
      }
    });
  });
  return out;
}

bool openFromOutside(const SphereGrid& scene, const SurfacePlace& place, double probe_A) {
  constexpr double kLift_A = 1e-4;
  const double far = glm::distance(scene.low_A(), scene.high_A()) + 2.0 * probe_A + 1.0;
  return sweep(scene, probe_A, place.scp_A + place.outward * far, place.scp_A + place.outward * kLift_A).sphere < 0;
}

}  // namespace moltact
