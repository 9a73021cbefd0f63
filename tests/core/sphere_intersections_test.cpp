#include "engine/core/sphere_intersections.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace moltact;

TEST_CASE("spheres of radii 5 and sqrt 13 that are 6 A apart meet 4 A along in a circle of radius 3 A") {
  const auto circle = circleOf({Vec3(1, 1, 1), 5}, {Vec3(7, 1, 1), std::sqrt(13.0)});
  REQUIRE(circle);
  CHECK(circle->centre_A.x == doctest::Approx(5));
  CHECK(circle->radius_A == doctest::Approx(3));
  CHECK_FALSE(circleOf({Vec3(0), 1}, {Vec3(3, 0, 0), 1}));
  CHECK_FALSE(circleOf({Vec3(0), 3}, {Vec3(1, 0, 0), 1}));
  CHECK_FALSE(circleOf({Vec3(0), 1}, {Vec3(0), 1}));
}

TEST_CASE("three spheres of radius 2 A at the corners of a 2 A triangle meet sqrt(8/3) A above and below its middle") {
  const Sphere a{Vec3(0, 0, 0), 2}, b{Vec3(2, 0, 0), 2}, c{Vec3(1, std::sqrt(3.0), 0), 2};
  const auto points = pointsOf(a, b, c);
  REQUIRE(points);
  for (const Vec3& p : *points) {
    CHECK(p.x == doctest::Approx(1));
    CHECK(p.y == doctest::Approx(1 / std::sqrt(3.0)));
    CHECK(std::abs(p.z) == doctest::Approx(std::sqrt(8.0 / 3.0)));
  }
  CHECK((*points)[0].z * (*points)[1].z < 0);
}

TEST_CASE("of two unit spheres whose surfaces overlap by 1e-12 A the circle's radius is right to six digits") {
  // Closed form: r^2 = 1 - (d / 2)^2 = (1 - d / 2) (1 + d / 2), with d = 2 - 1e-12 as the computer holds it.
  const double d = 2.0 - 1e-12, radius = std::sqrt((1.0 - d / 2.0) * (1.0 + d / 2.0));
  const auto circle = circleOf({Vec3(0), 1}, {Vec3(d, 0, 0), 1});
  REQUIRE(circle);
  CHECK(circle->radius_A == doctest::Approx(radius).epsilon(1e-6));
}

TEST_CASE("a probe of 1.4 A inflates a sphere of 1.7 A to 3.1 A") {
  CHECK(inflated({Vec3(1, 2, 3), 1.7}, 1.4).radius_A == doctest::Approx(3.1));
}
