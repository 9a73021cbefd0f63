// Accessible areas against closed forms, random points and another program.
#include "engine/structure/accessible_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

double sphere_A2(double radius_A) { return 4.0 * std::numbers::pi * radius_A * radius_A; }

/// The area of sphere `i` by random directions, each asked of every sphere that is near.
double byChance_A2(const std::vector<Sphere>& spheres, std::size_t i, double probe_A, int points,
                   std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double r = spheres[i].radius_A + probe_A;
  std::vector<Sphere> near;
  for (std::size_t j = 0; j < spheres.size(); ++j)
    if (j != i && glm::distance(spheres[i].centre_A, spheres[j].centre_A) < r + spheres[j].radius_A + probe_A)
      near.push_back({spheres[j].centre_A, spheres[j].radius_A + probe_A});
  int free = 0;
  for (int k = 0; k < points; ++k) {
    const Vec3 p = spheres[i].centre_A + r * glm::normalize(Vec3(normal(random), normal(random), normal(random)));
    free += std::none_of(near.begin(), near.end(),
                         [&](const Sphere& b) { return glm::distance(p, b.centre_A) < b.radius_A; });
  }
  return sphere_A2(r) * free / points;
}

}  // namespace

TEST_CASE("a sphere alone has the whole area of its grown sphere, two that meet have it less their caps") {
  const std::vector<Sphere> one{{Vec3(3, 4, 5), 1.7}};
  CHECK(accessibleAreas_A2(one)[0] == doctest::Approx(sphere_A2(3.1)));
  CHECK(accessibleAreas_A2(one, 0.0)[0] == doctest::Approx(sphere_A2(1.7)));
  // Grown radii 3 and 4 at a distance of 5: a right angle. The caps are 3 - 9/5 and 4 - 16/5 high.
  const std::vector<Sphere> two{{Vec3(0.0), 2.0}, {Vec3(5, 0, 0), 3.0}};
  const auto areas = accessibleAreas_A2(two, 1.0);
  CHECK(areas[0] == doctest::Approx(sphere_A2(3) - 2 * std::numbers::pi * 3 * (3 - 1.8)).epsilon(0.002));
  CHECK(areas[1] == doctest::Approx(sphere_A2(4) - 2 * std::numbers::pi * 4 * (4 - 3.2)).epsilon(0.002));
}

TEST_CASE("a sphere within another has no area, and of two in one place the first has all") {
  const std::vector<Sphere> spheres{
      {Vec3(0.0), 2.0}, {Vec3(0.5, 0, 0), 1.0}, {Vec3(20, 0, 0), 1.5}, {Vec3(20, 0, 0), 1.5}};
  const auto areas = accessibleAreas_A2(spheres);
  CHECK(areas[0] == doctest::Approx(sphere_A2(3.4)));
  CHECK(areas[1] == 0.0);
  CHECK(areas[2] == doctest::Approx(sphere_A2(2.9)));
  CHECK(areas[3] == 0.0);
  CHECK(accessibleSpheres(spheres) == std::vector<bool>{true, false, true, false});
  CHECK(accessibleAreas_A2({}).empty());
}

TEST_CASE("ubiquitin and lysozyme have the areas that FreeSASA gives, to half a percent") {
  // freesasa 2.1.2 --radius-from-occupancy --lee-richards --resolution=200 on the atoms of molecules/1ubq.pdb and
  // 1hel.pdb with Bondi's radii in the column of occupancies.
  const std::pair<const char*, double> known[] = {{"1ubq.pdb", 4870.62}, {"1hel.pdb", 6713.58}};
  for (const auto& [file, total_A2] : known) {
    const Molecule m = libraryMolecule(file);
    const auto areas = accessibleAreas_A2(m.spheres);
    CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == doctest::Approx(total_A2).epsilon(0.005));
  }
}

TEST_CASE("each residue of ubiquitin has FreeSASA's area, to 1.5 % or 1 A2") {
  // By the command above with --format=seq.
  const double known_A2[76] = {56.39, 78.48,  0.00,  54.89, 0.56,   100.26, 25.92,  140.20, 123.39, 68.93,  93.43,
                               67.18, 7.13,   61.93, 7.75,  147.73, 5.01,   101.56, 46.42,  85.21,  34.72,  46.73,
                               0.40,  121.52, 52.75, 0.24,  15.74,  45.72,  66.14,  1.49,   78.47,  135.89, 110.84,
                               73.33, 48.74,  30.97, 47.40, 48.99,  85.26,  45.83,  0.39,   90.32,  0.76,   29.14,
                               37.13, 73.23,  76.29, 92.14, 104.36, 8.06,   119.54, 65.40,  48.68,  118.37, 29.55,
                               0.11,  66.05,  91.21, 41.50, 113.01, 6.62,   117.88, 132.27, 103.20, 18.82,  56.21,
                               0.30,  84.17,  6.50,  36.82, 81.76,  113.42, 116.97, 207.13, 73.87,  145.82};
  const Molecule m = libraryMolecule("1ubq.pdb");
  const auto areas = accessibleAreas_A2(m.spheres);
  REQUIRE(m.residues.size() == 76);
  for (std::size_t r = 0; r < 76; ++r) {
    double sum = 0.0;
    for (std::uint32_t k = 0; k < m.residues[r].atom_count; ++k) sum += areas[m.residues[r].first_atom + k];
    CAPTURE(m.residues[r].number);
    CHECK(std::abs(sum - known_A2[r]) < std::max(1.0, 0.015 * known_A2[r]));
  }
}

TEST_CASE("30 atoms of ubiquitin have the area that 100 000 random points each find, to 1 A2 or four standard errors") {
  const unsigned seed = 20;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto spheres = libraryMolecule("1ubq.pdb").spheres.copy();
  const auto areas = accessibleAreas_A2(spheres);
  const auto touched = accessibleSpheres(spheres);
  constexpr int kPoints = 100'000;
  for (int k = 0; k < 30; ++k) {
    const std::size_t i = random() % spheres.size();
    const double expected = byChance_A2(spheres, i, kWaterProbe_A, kPoints, random);
    const double whole = sphere_A2(spheres[i].radius_A + kWaterProbe_A), share = expected / whole;
    const double error = 4.0 * whole * std::sqrt(share * (1.0 - share) / kPoints);
    CHECK(std::abs(areas[i] - expected) < std::max(1.0, error));
    if (areas[i] > 2.0) CHECK(touched[i]);
    if (areas[i] == 0.0) CHECK(expected < 0.5);
  }
}
