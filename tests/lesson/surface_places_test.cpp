// Surface places of two and three equal spheres, which have closed forms, and of a protein, where every place is
// checked against every sphere.
#include "engine/lesson/surface_places.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>

#include "engine/core/random.h"
#include "engine/core/sphere_intersections.h"
#include "engine/lesson/hand_plan.h"
#include "engine/molecule/reader.h"

using namespace moltact;

namespace {

std::vector<std::uint32_t> allOf(const SphereGrid& scene) {
  std::vector<std::uint32_t> out(scene.size());
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

}  // namespace

TEST_CASE("the crease of two spheres of 1.88 A that touch is a circle of 2.688 A, whole, and open from outside") {
  const SphereGrid scene({{{-1.88, 0, 0}, 1.88}, {{1.88, 0, 0}, 1.88}});
  const auto places = creasePlaces(scene, allOf(scene), 1.4, 0.2);
  CHECK(places.size() == std::size_t(std::ceil(2 * 3.14159265358979 * std::sqrt(3.28 * 3.28 - 1.88 * 1.88) / 0.2)));
  for (const SurfacePlace& p : places) {
    CHECK(std::abs(p.scp_A.x) < 1e-9);
    CHECK(glm::length(p.scp_A) == doctest::Approx(std::sqrt(3.28 * 3.28 - 1.88 * 1.88)));
    CHECK(openFromOutside(scene, p, 1.4));
  }
}

TEST_CASE("a push into the crease of an atom that lies deep in another, as hydrogen in oxygen, is held by both") {
  // The hand's push must be a sum of pushes against both atoms with shares above 0.
  const SphereGrid scene({{{0, 0, 0}, 1.52}, {{0.96, 0, 0}, 1.1}});
  const auto places = creasePlaces(scene, allOf(scene), 1.0, 0.2);
  REQUIRE(places.size() >= 12);
  for (const SurfacePlace& p : places) {
    const Vec3 a = glm::normalize(p.scp_A - scene[0].centre_A), b = glm::normalize(p.scp_A - scene[1].centre_A);
    const double ab = glm::dot(a, b), ua = glm::dot(p.outward, a), ub = glm::dot(p.outward, b);
    const double share_a = (ua - ab * ub) / (1 - ab * ab), share_b = (ub - ab * ua) / (1 - ab * ab);
    CHECK(share_a > 0.1);
    CHECK(share_b > 0.1);
    CHECK(glm::length(share_a * a + share_b * b - p.outward) < 1e-9);
  }
}

TEST_CASE("three spheres of 1.88 A that touch one another have two pits 2.456 A above and below their plane") {
  const double h = 3.76 / std::sqrt(3.0);
  const SphereGrid scene({{{h, 0, 0}, 1.88}, {{-h / 2, 1.88, 0}, 1.88}, {{-h / 2, -1.88, 0}, 1.88}});
  const auto places = pitPlaces(scene, allOf(scene), 1.4);
  REQUIRE(places.size() == 2);
  for (const SurfacePlace& p : places) {
    CHECK(std::abs(p.scp_A.z) == doctest::Approx(std::sqrt(3.28 * 3.28 - h * h)));
    CHECK(std::abs(p.outward.z) == doctest::Approx(1.0));
  }
}

TEST_CASE(
    "creases of spheres as large as a file may have them, 1e9 A, have 20 000 places, all on the crease, and a slide "
    "along one 20 000 steps at most") {
  const double radius_A = 1e9, half_A = 0.6e9;
  const SphereGrid scene({{{-half_A, 0, 0}, radius_A}, {{half_A, 0, 0}, radius_A}});
  const auto places = creasePlaces(scene, allOf(scene), 1.4, 0.2);
  CHECK(places.size() == std::size_t(kMaxCreasePlaces));
  for (const SurfacePlace& p : places) {
    CHECK(std::abs(p.scp_A.x) < 1.0);
    CHECK(glm::length(p.scp_A) == doctest::Approx(0.8e9).epsilon(1e-6));
  }
  HandPlan plan;
  slide(plan, {.spheres = scene}, places.front(), places[places.size() / 2], 0.1);
  CHECK(plan.size() == 20'000);
  REQUIRE(plan.back().to.has_value());
  CHECK(glm::distance(plan.back().to->A, places[places.size() / 2].scp_A) < 1.0);
}

TEST_CASE("every face, crease and pit place of ubiquitin lies on its atoms' grown spheres and in no other") {
  const auto molecule = readMolecule(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb");
  REQUIRE(molecule);
  const SphereGrid scene(molecule->spheres);
  const double probe_A = 1.4;
  int open = 0;
  for (const auto& places :
       {facePlaces(scene, allOf(scene), probe_A, 40), creasePlaces(scene, allOf(scene), probe_A, 0.5),
        pitPlaces(scene, allOf(scene), probe_A)}) {
    CHECK(places.size() > 300);
    for (const SurfacePlace& p : places) {
      std::size_t on = 0, in = 0;
      for (std::size_t i = 0; i < scene.size(); ++i) {
        const double gap = glm::distance(p.scp_A, scene[i].centre_A) - scene[i].radius_A - probe_A;
        on += std::abs(gap) < 1e-6;
        in += gap < -1e-6;
      }
      REQUIRE(in == 0);
      REQUIRE(on >= std::size_t(p.feature));
      open += openFromOutside(scene, p, probe_A);
    }
  }
  CHECK(open > 1000);
}

TEST_CASE(
    "the pits and creases of 40 spheres for probes of 1.4 to 20 A are those that trying every triple and pair gives") {
  std::uint64_t seed = 20261124;
  const auto fraction = [&] { return nextFraction(seed); };
  std::vector<Sphere> spheres;
  for (int k = 0; k < 40; ++k)
    spheres.push_back({{9.0 * fraction(), 9.0 * fraction(), 9.0 * fraction()}, 1.2 + 0.8 * fraction()});
  const SphereGrid scene(spheres);
  for (const double probe_A : {1.4, 6.0, 10.0, 20.0}) {
    CAPTURE(probe_A);
    // How far a place lies off the nearest sphere but those that hold it.
    const auto clear_A = [&](const Vec3& place, std::initializer_list<std::size_t> but) {
      double least = 1e9;
      for (std::size_t i = 0; i < spheres.size(); ++i)
        if (std::find(but.begin(), but.end(), i) == but.end())
          least = std::min(least, glm::distance(place, spheres[i].centre_A) - spheres[i].radius_A - probe_A);
      return least;
    };
    std::size_t pits = 0;
    const auto found = pitPlaces(scene, allOf(scene), probe_A);
    const auto creases = creasePlaces(scene, allOf(scene), probe_A, 0.1);
    std::size_t on_creases = 0;
    for (std::size_t a = 0; a < spheres.size(); ++a)
      for (std::size_t b = a + 1; b < spheres.size(); ++b) {
        const auto circle = circleOf(inflated(spheres[a], probe_A), inflated(spheres[b], probe_A));
        if (!circle) continue;
        const Vec3 x = glm::normalize(glm::cross(circle->axis, Vec3(0.3, 0.5, 0.8))), y = glm::cross(circle->axis, x);
        for (int k = 0; k < 60; ++k) {
          const double turn = 2.0 * 3.14159265358979 * k / 60.0;
          const Vec3 place = circle->centre_A + (x * std::cos(turn) + y * std::sin(turn)) * circle->radius_A;
          // Nearer to its end than two places are apart, a stretch may have none.
          if (clear_A(place, {a, b}) < 0.2) continue;
          ++on_creases;
          CHECK(std::any_of(creases.begin(), creases.end(), [&](const SurfacePlace& p) {
            return p.atoms[0] == int(a) && p.atoms[1] == int(b) && glm::distance(p.scp_A, place) < 0.11;
          }));
        }
        for (std::size_t c = b + 1; c < spheres.size(); ++c)
          if (const auto points =
                  pointsOf(inflated(spheres[a], probe_A), inflated(spheres[b], probe_A), inflated(spheres[c], probe_A)))
            for (const Vec3& place : {(*points)[0], (*points)[1]}) {
              if (clear_A(place, {a, b, c}) < 1e-6) continue;
              ++pits;
              CHECK(std::any_of(found.begin(), found.end(),
                                [&](const SurfacePlace& p) { return glm::distance(p.scp_A, place) < 1e-6; }));
            }
      }
    CHECK(found.size() == pits);
    CHECK(pits > 10);
    CHECK(on_creases > 50);
  }
}
