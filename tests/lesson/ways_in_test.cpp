// The searches behind the facts of lessons: what a sphere can touch from outside, against places known in closed form.
#include "engine/lesson/ways_in.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace moltact;

namespace {

constexpr double kSphere_A = 1.4, kAtom_A = 1.7;

// A hollow sphere of atoms of 1.7 A around an atom in its middle. It is open within this angle of the z axis and has no
// other gap.
std::vector<Sphere> hull(double hole_deg) {
  std::vector<Sphere> out{{Vec3(0.0), kAtom_A}};
  const int n = 2000;
  for (int k = 0; k < n; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / n, turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * k;
    if (z > std::cos(hole_deg * std::numbers::pi / 180.0)) continue;
    const double r = std::sqrt(1.0 - z * z);
    out.push_back({Vec3(r * std::cos(turn), r * std::sin(turn), z) * 10.0, kAtom_A});
  }
  return out;
}

}  // namespace

TEST_CASE(
    "an atom inside a closed hull is not touched; through a hole of 10 A x sin 30 = 5 A in radius less 3.1 A it is, "
    "straight "
    "and by a flood") {
  const WaysIn shut(hull(0.0), kSphere_A);
  CHECK_FALSE(shut.straight(0));
  CHECK_FALSE(shut.crooked(0));
  const WaysIn open(hull(30.0), kSphere_A);
  CHECK(open.straight(0));
  CHECK(open.crooked(0));
}

TEST_CASE("behind a lid before the hole an atom is touched round the corner and not straight") {
  std::vector<Sphere> spheres = hull(35.0);
  // A lid of radius 8 A, 8 A above the hole's edge: it blocks every straight line through the hole, but the sphere
  // passes under its rim.
  for (double x = -14.0; x <= 14.0; x += 1.0)
    for (double y = -14.0; y <= 14.0; y += 1.0)
      if (std::hypot(x, y) <= 14.0) spheres.push_back({Vec3(x, y, 15.5), kAtom_A});
  const WaysIn ways(spheres, kSphere_A);
  CHECK_FALSE(ways.straight(0));
  CHECK(ways.crooked(0));
}

TEST_CASE(
    "of one of two equal atoms 3 A apart a sphere of 1.4 A can rest on 74 % of the sphere, as the cap that the other "
    "covers says") {
  const double grid_spacing_A = 3.0, grown_A = kAtom_A + kSphere_A;
  const WaysIn pair(std::vector<Sphere>{{Vec3(0.0), kAtom_A}, {Vec3(grid_spacing_A, 0, 0), kAtom_A}}, kSphere_A);
  CHECK(pair.share(0) == doctest::Approx(0.5 * (1.0 + 0.5 * grid_spacing_A / grown_A)).epsilon(0.001));
  CHECK(pair.straight(0));
}
