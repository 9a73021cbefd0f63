// Places of two and three equal balls, which have closed forms, and of a protein, where every place is checked ball by
// ball.
#include "engine/lesson/surface_places.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "engine/lesson/hand_plan.h"
#include "engine/molecule/reader.h"

using namespace moltact;

namespace {

std::vector<std::uint32_t> allOf(const BallScene& scene) {
  std::vector<std::uint32_t> out(scene.size());
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

}  // namespace

TEST_CASE("the crease of two balls of 1.88 A that touch is a circle of 2.688 A, whole, and open from outside") {
  const BallScene scene({{{-1.88, 0, 0}, 1.88}, {{1.88, 0, 0}, 1.88}});
  const auto places = creasePlaces(scene, allOf(scene), 1.4, 0.2);
  CHECK(places.size() == std::size_t(std::ceil(2 * 3.14159265358979 * std::sqrt(3.28 * 3.28 - 1.88 * 1.88) / 0.2)));
  for (const SurfacePlace& p : places) {
    CHECK(std::abs(p.scp_A.x) < 1e-9);
    CHECK(glm::length(p.scp_A) == doctest::Approx(std::sqrt(3.28 * 3.28 - 1.88 * 1.88)));
    CHECK(openFromOutside(scene, p, 1.4));
  }
}

TEST_CASE("three balls of 1.88 A that touch one another have two pits 2.456 A above and below their plane") {
  const double h = 3.76 / std::sqrt(3.0);
  const BallScene scene({{{h, 0, 0}, 1.88}, {{-h / 2, 1.88, 0}, 1.88}, {{-h / 2, -1.88, 0}, 1.88}});
  const auto places = pitPlaces(scene, allOf(scene), 1.4);
  REQUIRE(places.size() == 2);
  for (const SurfacePlace& p : places) {
    CHECK(std::abs(p.scp_A.z) == doctest::Approx(std::sqrt(3.28 * 3.28 - h * h)));
    CHECK(std::abs(p.outward.z) == doctest::Approx(1.0));
  }
}

TEST_CASE(
    "creases of balls as large as a file may have them, 1e9 A, have 20 000 places, all on the crease, and a slide "
    "along one 20 000 steps at most") {
  const double radius_A = 1e9, half_A = 0.6e9;
  const BallScene scene({{{-half_A, 0, 0}, radius_A}, {{half_A, 0, 0}, radius_A}});
  const auto places = creasePlaces(scene, allOf(scene), 1.4, 0.2);
  CHECK(places.size() == std::size_t(kMostCreasePlaces));
  for (const SurfacePlace& p : places) {
    CHECK(std::abs(p.scp_A.x) < 1.0);
    CHECK(glm::length(p.scp_A) == doctest::Approx(0.8e9).epsilon(1e-6));
  }
  HandPlan plan;
  slide(plan, {.balls = scene}, places.front(), places[places.size() / 2], 0.1);
  CHECK(plan.size() == 20'000);
  REQUIRE(plan.back().to.has_value());
  CHECK(glm::distance(plan.back().to->A, places[places.size() / 2].scp_A) < 1.0);
}

TEST_CASE("every face, crease and pit place of ubiquitin lies on its atoms' grown spheres and in no other") {
  const auto molecule = readMolecule(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb");
  REQUIRE(molecule);
  const BallScene scene(molecule->balls());
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
