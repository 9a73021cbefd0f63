// Equations 2 to 7 and the cone test of the paper, computed by hand for the triangles 13-14-15 (altitude 12, which
// divides 14 into 5 and 9), 3-4-5 and 8-15-17.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/haptics/paper/cone.h"
#include "engine/haptics/paper/intersection_circle.h"
#include "engine/haptics/paper/intersection_point.h"

using namespace moltact;
using namespace moltact::paper;

namespace {
void paperFormulasCheckNear(const Vec3& a, const Vec3& b) { CHECK(glm::distance(a, b) < 1e-13 * (1 + glm::length(b))); }
}  // namespace

TEST_CASE("spheres of radii 15 and 13 with centres 14 apart meet in a circle of radius 12, 9 from the first") {
  CHECK(circleHeight(15, 13, 14) == 9.0);
  CHECK(circleHeight(13, 15, 14) == 5.0);
  const auto circle = intersectionCircle({1, 2, 3}, 15, {1, 16, 3}, 13);
  REQUIRE(circle);
  CHECK(circle->radius == doctest::Approx(12));
  CHECK(circle->height == 9.0);
  paperFormulasCheckNear(circle->axis, {0, 1, 0});
  paperFormulasCheckNear(circle->centre, {1, 11, 3});  // S0 + 9; the printed S1 + S^ x would give 25
}

TEST_CASE("a circle behind the smaller sphere's centre has a negative height") {
  // Radii 13 and 20, centres 11 apart: altitude 12 of the triangle, foot 5 behind the first centre (5, 12,
  // 13; 16, 12, 20).
  const auto circle = intersectionCircle({0, 0, 0}, 13, {11, 0, 0}, 20);
  REQUIRE(circle);
  CHECK(circle->height == -5.0);
  CHECK(circle->radius == doctest::Approx(12));
}

TEST_CASE("spheres apart, touching in one point, contained, equal or with one centre have no circle") {
  CHECK_FALSE(intersectionCircle({0, 0, 0}, 3, {7, 0, 0}, 3));
  CHECK_FALSE(intersectionCircle({0, 0, 0}, 3, {6, 0, 0}, 3));
  CHECK_FALSE(intersectionCircle({0, 0, 0}, 3, {2, 0, 0}, 1));
  CHECK_FALSE(intersectionCircle({0, 0, 0}, 5, {1, 0, 0}, 1));
  CHECK_FALSE(intersectionCircle({0, 0, 0}, 3, {0, 0, 0}, 3));
  CHECK_FALSE(intersectionCircle({0, 0, 0}, 3, {0, 0, 0}, 2));
}

TEST_CASE("spheres of radius 3 that overlap by 1e-9 meet in a circle of radius 5.477e-5, right to 6 digits") {
  const auto circle = intersectionCircle({0, 0, 0}, 3, {6 - 1e-9, 0, 0}, 3);
  REQUIRE(circle);
  CHECK(circle->radius == doctest::Approx(std::sqrt(3e-9)).epsilon(1e-6));  // a^2 = R^2 - (d/2)^2 = 3e-9
}

TEST_CASE("the closest place on a circle lies toward the HIP, and from the axis toward the last place") {
  const auto circle = *intersectionCircle({-3, 0, 0}, 5, {3, 0, 0}, 5);
  paperFormulasCheckNear(closestOnCircle(circle, {2, 3, 4}, {0, 0, 4}), {0, 2.4, 3.2});
  paperFormulasCheckNear(closestOnCircle(circle, {2, 0, 0}, {0, -4, 0}), {0, -4, 0});
  CHECK(std::isfinite(closestOnCircle(circle, {2, 0, 0}, {1, 0, 0}).y));
}

TEST_CASE("the cone of height 9 and radius 12 holds (6, 7.9) but not (6, 8.1), and (20, 11.9) but not (20, 12.1)") {
  const Cone cone{*intersectionCircle({0, 0, 0}, 15, {14, 0, 0}, 13), {0, 0, 0}, 4, 7};
  CHECK(insideCone(cone, {6, 7.9, 0}));  // 12 / 9 x 6 = 8
  CHECK_FALSE(insideCone(cone, {6, 8.1, 0}));
  CHECK(insideCone(cone, {20, 0, 11.9}));  // the text has no test for the base
  CHECK_FALSE(insideCone(cone, {20, 0, 12.1}));
  CHECK_FALSE(insideCone(cone, {-1, 0, 0}));
}

TEST_CASE("past its base, at 9, a cone hands over to the neighbour's, whose height is 5") {
  const Cone cone{*intersectionCircle({0, 0, 0}, 15, {14, 0, 0}, 13), {0, 0, 0}, 4, 7};
  CHECK_FALSE(pastBase(cone, {8.999, 1, 1}));
  CHECK(pastBase(cone, {9.001, 1, 1}));
  const Cone other = neighbourCone(cone, {14, 0, 0});
  CHECK(other.atom == 7);
  CHECK(other.neighbour == 4);
  CHECK(other.circle.height == doctest::Approx(5));
  paperFormulasCheckNear(other.circle.axis, {-1, 0, 0});
  CHECK(insideCone(other, {12, 4.7, 0}));  // 12 / 5 x 2 = 4.8
  CHECK_FALSE(insideCone(other, {12, 4.9, 0}));
}

TEST_CASE("spheres of radius 17 at -8 and 8 and one of radius 13 at 14 across meet in (0, 9, 12) and (0, 9, -12)") {
  const auto circle = *intersectionCircle({-8, 0, 0}, 17, {8, 0, 0}, 17);  // radius 15
  const auto points = intersectionPoints(circle, {0, 14, 0}, 13);
  REQUIRE(points);
  paperFormulasCheckNear(points->P0, {0, 9, 12});  // F = n x V = x x y = z
  paperFormulasCheckNear(points->P1, {0, 9, -12});
}

TEST_CASE("a third sphere whose centre lies 3 off the circle's plane cuts it in a smaller circle") {
  // Circle of radius 4 at the origin; sphere of radius 5 at (3, 4, 0) cuts the plane in a circle of radius 4
  // round (0, 4, 0); K = 4, x = 2, y^2 = 16 - 4.
  const auto circle = *intersectionCircle({-3, 0, 0}, 5, {3, 0, 0}, 5);
  const auto points = intersectionPoints(circle, {3, 4, 0}, 5);
  REQUIRE(points);
  paperFormulasCheckNear(points->P0, {0, 2, std::sqrt(12.0)});
  paperFormulasCheckNear(points->P1, {0, 2, -std::sqrt(12.0)});
}

TEST_CASE("a third sphere beside the plane, round the whole circle, on it or only touching it gives no points") {
  const auto circle = *intersectionCircle({-3, 0, 0}, 5, {3, 0, 0}, 5);
  CHECK_FALSE(intersectionPoints(circle, {6, 0, 0}, 5));
  CHECK_FALSE(intersectionPoints(circle, {0, 1, 0}, 9));
  CHECK_FALSE(intersectionPoints(circle, {0, 0, 0}, 4));
  CHECK_FALSE(intersectionPoints(circle, {0, 6, 0}, 2));
}

TEST_CASE(
    "the plane of the circle at the point (0, 9, 12) has the normal (0, 0.8, -0.6), toward the third "
    "sphere") {
  const auto volume = pointVolume({0, 9, 12}, {5, 6, 7}, {Vec3(-8, 0, 0), Vec3(8, 0, 0), Vec3(0, 14, 0)});
  REQUIRE(volume);
  paperFormulasCheckNear(volume->planes[0].normal, {0, 0.8, -0.6});  // T = (0, 9, 12), N = T x n = (0, 12, -9) / 15
  CHECK(volume->planes[0].circle == std::array{5, 6});
  // Straight under the point between the centres is inside; past the first plane its circle is the one to go
  // to.
  CHECK_FALSE(volume->crossed({0, 6, 4}));
  const PointPlane* out = volume->crossed({0, 2, 8});
  REQUIRE(out);
  CHECK(out->circle == std::array{5, 6});
  CHECK(volume->crossed({4, 14, 8})->circle == std::array{6, 7});
}

TEST_CASE("a point in one plane with the three centres has no volume") {
  CHECK_FALSE(pointVolume({0, 4, 0}, {0, 1, 2}, {Vec3(-3, 0, 0), Vec3(3, 0, 0), Vec3(0, 9, 0)}));
}
