// Oracles: volumes in closed form, Euler's formula, and that each edge is traversed once in each direction.
#include "engine/gltf/closed_surface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

using namespace moltact;

namespace {

constexpr double kPi = std::numbers::pi;

// Every edge belongs to two triangles, which walk it in opposite ways: closed, and turned the same way everywhere.
bool closedAndOriented(const ClosedSurface& s) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> walked;
  for (std::size_t k = 0; k < s.triangles.size(); k += 3)
    for (std::size_t e = 0; e < 3; ++e)
      if (!walked.insert({s.triangles[k + e], s.triangles[k + (e + 1) % 3]}).second) return false;
  for (const auto& [a, b] : walked)
    if (!walked.contains({b, a})) return false;
  return !walked.empty();
}

int euler(const ClosedSurface& s) {
  return int(s.places.size()) - int(s.triangles.size() / 2) + int(s.triangles.size() / 3);
}

double volume(const ClosedSurface& s) {
  double sum = 0;
  for (std::size_t k = 0; k < s.triangles.size(); k += 3) {
    const auto p = [&](std::size_t e) { return Vec3(s.places[s.triangles[k + e]]); };
    sum += glm::dot(p(0), glm::cross(p(1), p(2))) / 6;
  }
  return sum;
}

double gap(const Vec3& p, const std::vector<Sphere>& spheres) {
  double least = 1e9;
  for (const Sphere& b : spheres) least = std::min(least, glm::distance(p, b.centre_A) - b.radius_A);
  return least;
}

}  // namespace

TEST_CASE(
    "a sphere of 1.7 A in steps of 0.1 A is one closed surface with its volume to 1 % and its corners within 0.003 A") {
  const std::vector<Sphere> spheres{{Vec3(1e6, -3, 0.123), 1.7}};
  const ClosedSurface s = closedSurface(spheres, 0.1);
  CHECK(closedAndOriented(s));
  CHECK(euler(s) == 2);
  CHECK(volume(s) == doctest::Approx(4 * kPi / 3 * std::pow(1.7, 3)).epsilon(0.01));
  double worst = 0;
  for (std::size_t k = 0; k < s.places.size(); ++k) {
    worst = std::max(worst, std::abs(double(glm::length(s.places[k])) - 1.7));
    CHECK(glm::dot(s.normals[k], glm::normalize(s.places[k])) > 0.999f);
  }
  CHECK(worst < 0.1 * 0.1 / (2 * 1.7));
}

TEST_CASE(
    "two spheres that overlap are one surface of the volume of both less the lens; apart they are two, touching or "
    "not") {
  const double r = 1.5, d = 1.8, h = r - d / 2;
  const double lens = 2 * kPi * h * h * (3 * r - h) / 3, sphere = 4 * kPi / 3 * r * r * r;
  const ClosedSurface one = closedSurface(std::vector<Sphere>{{Vec3(0), r}, {Vec3(d, 0, 0), r}}, 0.08);
  CHECK(closedAndOriented(one));
  CHECK(euler(one) == 2);
  CHECK(volume(one) == doctest::Approx(2 * sphere - lens).epsilon(0.01));
  const ClosedSurface two = closedSurface(std::vector<Sphere>{{Vec3(0), r}, {Vec3(4, 1, 0), r}}, 0.08);
  CHECK(closedAndOriented(two));
  CHECK(euler(two) == 4);
  CHECK(closedAndOriented(closedSurface(std::vector<Sphere>{{Vec3(0), r}, {Vec3(2 * r, 0, 0), r}}, 0.1)));
}

TEST_CASE(
    "heaps of 80 spheres at random are closed, and each triangle lies on the sphere that it is coloured by; seeds 1 to "
    "4") {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-6, 6), radius(1.0, 2.0);
    std::vector<Sphere> spheres;
    for (int k = 0; k < 80; ++k) spheres.push_back({Vec3(place(random), place(random), place(random)), radius(random)});
    spheres.push_back({Vec3(0), 0.0});  // no radius: left out
    const double step = 0.3;
    const ClosedSurface s = closedSurface(spheres, step);
    CHECK(closedAndOriented(s));
    CHECK(volume(s) > 0);
    double worst = 0, worst_colour = 0;
    for (const glm::vec3& p : s.places) worst = std::max(worst, std::abs(gap(s.middle_A + Vec3(p), spheres)));
    for (std::size_t t = 0; t < s.owners.size(); ++t) {
      Vec3 middle = s.middle_A;
      for (std::size_t e = 0; e < 3; ++e) middle += Vec3(s.places[s.triangles[3 * t + e]]) / 3.0;
      const Sphere& owner = spheres[s.owners[t]];
      worst_colour = std::max(worst_colour, std::abs(glm::distance(middle, owner.centre_A) - owner.radius_A));
    }
    CHECK(worst < step);
    CHECK(worst_colour < step);
  }
}

TEST_CASE("no sphere gives no triangle, and 100 A in steps of 0.1 A are reported as 1e9 cells") {
  CHECK(closedSurface({}, 0.1).triangles.empty());
  const std::vector<Sphere> wide{{Vec3(0), 50.0}};
  CHECK(cellCount(wide, 0.1) == doctest::Approx(1004.0 * 1004 * 1004));
  CHECK(cellCount(wide, usualStep_A(wide)) < kMaxCells);
}
