// Oracles: polynomials that the interpolations reproduce; the direct sum (PairSum) at the nodes and between them; differences
// of the energy.
#include "engine/haptics/field/energy_grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/haptics/field/compute_grid.h"
#include "tests/haptics/allocations.h"

using namespace moltact;

namespace {

struct Scene {
  std::vector<PairAtom> atoms, body;
  std::shared_ptr<const SphereGrid> grid;
};

// Atoms about 2 A apart round an empty ball of 5 A, and a body of `held` atoms of three sizes within 2 A.
Scene crowd(unsigned seed, int held = 12) {
  std::mt19937 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  Scene out;
  std::vector<Sphere> spheres;
  while (out.atoms.size() < 900) {
    const Vec3 at(in(-14, 14), in(-14, 14), in(-14, 14));
    if (glm::length(at) < 5.0) continue;
    out.atoms.push_back({at, float(in(0.6, 2.1)), float(in(0.0, 0.25)), float(in(-0.8, 0.8))});
    spheres.push_back({at, 1.5});
  }
  constexpr float kSizes[] = {1.908f, 1.6612f, 0.6f};
  for (int k = 0; k < held; ++k)
    out.body.push_back(
        {Vec3(in(-2, 2), in(-2, 2), in(-2, 2)), kSizes[k % 3], float(in(0.02, 0.2)), float(in(-0.5, 0.5))});
  out.grid = std::make_shared<const SphereGrid>(std::move(spheres));
  return out;
}

std::shared_ptr<const GridMaps> mapsOf(const Scene& scene, double half_edge_A, double spacing_A, double fold,
                                       const PairModel& model = {}) {
  const auto box = gridBoxRound(Vec3(-half_edge_A), Vec3(half_edge_A), spacing_A);
  REQUIRE(box);
  auto maps = computeGridMaps(*scene.grid, scene.atoms, *box, gridSizes(scene.body), model, 2);
  REQUIRE(maps);
  if (fold > 0) foldWalls(*maps, fold);
  return std::make_shared<const GridMaps>(*std::move(maps));
}

EnergyGrid gridOf(const Scene& scene, std::shared_ptr<const GridMaps> coarse, std::shared_ptr<const GridMaps> fine,
                  GridInterpolation interpolation, double wall = 1.0) {
  const std::vector<float> sizes = gridSizes(scene.body);
  return EnergyGrid(std::move(coarse), std::move(fine), gridAtoms(scene.body, sizes), interpolation, wall);
}

PoseA pose(const Vec3& at, const Vec3& turn = Vec3(0.0)) {
  const double angle = glm::length(turn);
  return {{at}, angle > 0 ? glm::angleAxis(angle, turn / angle) : kNoRotation};
}

constexpr GridInterpolation kBoth[] = {GridInterpolation::Trilinear, GridInterpolation::Tricubic};

struct Difference {
  Vec3 force, torque;
};
Difference slopeOf(EnergyGrid& grid, const PoseA& at, double step_A) {
  Difference out;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step(0.0);
    step[axis] = step_A;
    const auto felt = [&](const PoseA& p) { return grid.at(p).energy.felt_kcal_mol; };
    out.force[axis] =
        (felt({{at.place.A - step}, at.orientation}) - felt({{at.place.A + step}, at.orientation})) / (2 * step_A);
    out.torque[axis] = (felt({at.place, pose({}, -step).orientation * at.orientation}) -
                        felt({at.place, pose({}, step).orientation * at.orientation})) /
                       (2 * step_A);
  }
  return out;
}

}  // namespace

TEST_CASE("the tricubic interpolation gives a quadratic with gradient and curvature to 1e-4, the trilinear a product") {
  const auto box = gridBoxRound(Vec3(-2, -1, 0), Vec3(2, 3, 1.5), 0.25);
  REQUIRE(box);
  CHECK(box->nodes == std::array<int, 3>{19, 19, 9});
  CHECK(glm::distance(box->low_A(), Vec3(-2, -1, 0)) < 1e-12);
  CHECK(glm::distance(box->high_A(), Vec3(2, 3, 1.5)) < 1e-12);
  const auto quadratic = [](const Vec3& p) { return 1 + p.x - 2 * p.y + p.x * p.x - 3 * p.y * p.z + 0.5 * p.z * p.z; };
  const auto product = [](const Vec3& p) { return (1 + p.x) * (2 - p.y) * (3 + p.z); };
  std::vector<float> quadratics(box->count()), products(box->count());
  for (int k = 0; k < box->nodes[2]; ++k)
    for (int j = 0; j < box->nodes[1]; ++j)
      for (int i = 0; i < box->nodes[0]; ++i) {
        quadratics[box->index(i, j, k)] = float(quadratic(box->node(i, j, k)));
        products[box->index(i, j, k)] = float(product(box->node(i, j, k)));
      }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int k = 0; k < 200; ++k) {
    const Vec3 p = Vec3(-2, -1, 0) + Vec3(share(random), share(random), share(random)) * Vec3(4, 4, 1.5);
    const auto cell = gridCell(*box, p);
    REQUIRE(cell);
    const GridSample cubic = curvedGridSample(*box, *cell, GridInterpolation::Tricubic, quadratics.data());
    CHECK(std::abs(cubic.value - quadratic(p)) < 2e-5);
    CHECK(glm::distance(cubic.gradient, Vec3(1 + 2 * p.x, -2 - 3 * p.z, -3 * p.y + p.z)) < 1e-4);
    const std::array<double, 6> curvature{2, 0, 1, 0, 0, -3};
    for (std::size_t c = 0; c < 6; ++c) CHECK(std::abs(cubic.curvature[c] - curvature[c]) < 2e-3);
    const GridSample linear = gridSample(*box, *cell, GridInterpolation::Trilinear, products.data());
    CHECK(std::abs(linear.value - product(p)) < 2e-5);
    CHECK(glm::distance(linear.gradient, Vec3((2 - p.y) * (3 + p.z), -(1 + p.x) * (3 + p.z), (1 + p.x) * (2 - p.y))) <
          2e-4);
  }
  for (const Vec3& p : {Vec3(-2.01, 0, 1), Vec3(0, 3.01, 1), Vec3(0, 0, -0.01), Vec3(NAN, 0, 1), Vec3(1e300, 0, 1)})
    CHECK_FALSE(gridCell(*box, p));
  CHECK(gridCell(*box, {2, 3, 1.5}));
}

TEST_CASE("a grid of 10 GB, a spacing of 0 and a box that is no number get a message and no box") {
  CHECK(gridBoxRound(Vec3(0), Vec3(500), 0.375).problem().text() ==
        "the grid would have more than 67 million points; choose a wider spacing or a smaller box");
  CHECK(gridBoxRound(Vec3(0), Vec3(1), 0.0).problem().text() ==
        "the spacing of the grid is not from 0.05 to 10 Å; 0.375 Å is customary");
  CHECK_FALSE(gridBoxRound(Vec3(0), Vec3(1), NAN));
  CHECK_FALSE(gridBoxRound(Vec3(0), Vec3(INFINITY), 0.375));
}

TEST_CASE(
    "an atom at a node has the energies of the direct sum to 1e-5 of their amounts, folded or not, in 3 dielectrics, "
    "and "
    "with the bound of the walls") {
  for (const Dielectric kind : {Dielectric::Constant, Dielectric::Distance, Dielectric::MehlerSolmajer})
    for (const double fold : {0.0, 4.0}) {
      Scene scene = crowd(3);
      PairModel model;
      model.kind = kind;
      scene.body = {{Vec3(0.0), 1.908f, 0.1f, 0.4f}};
      const auto maps = mapsOf(scene, 6.0, 0.5, fold, model);
      PairSum sum(scene.grid, scene.atoms, scene.body, model);
      for (const GridInterpolation interpolation : kBoth) {
        EnergyGrid grid = gridOf(scene, maps, {}, interpolation);
        for (int k = 0; k < 100; ++k) {
          const Vec3 at = -Vec3(6.0) + 0.5 * Vec3(k % 25, (k * 7) % 25, (k * 11) % 25);
          const PairEnergy right = sum.at(pose(at)), found = grid.at(pose(at));
          CHECK(found.energy.parts[EnergyPart::VanDerWaals] ==
                doctest::Approx(right.energy.parts[EnergyPart::VanDerWaals]).epsilon(1e-5));
          CHECK(std::abs(found.energy.parts[EnergyPart::Electrostatic] -
                         right.energy.parts[EnergyPart::Electrostatic]) < 2e-5);
          CHECK(found.energy.felt_kcal_mol == doctest::Approx(right.energy.felt_kcal_mol).epsilon(2e-5));
        }
      }
    }
}

TEST_CASE(
    "in the gap of 4 crowds, halving the spacing from 0.5 to 0.25 A lowers the error of force and torque by 1.7 times "
    "(trilinear) and 2.4 times (tricubic) at least, to 16 % and 7 % of their rms") {
  for (const GridInterpolation interpolation : kBoth) {
    double error[2]{}, torque_error[2]{}, size = 0, torque_size = 0;
    for (const unsigned seed : {11u, 12u, 13u, 14u}) {
      const Scene scene = crowd(seed);
      PairSum sum(scene.grid, scene.atoms, scene.body, {});
      EnergyGrid grids[]{gridOf(scene, mapsOf(scene, 4.5, 0.5, 4.0), {}, interpolation),
                         gridOf(scene, mapsOf(scene, 4.5, 0.25, 4.0), {}, interpolation)};
      std::mt19937 random(seed);
      std::normal_distribution<double> normal;
      const auto any = [&](double s) { return s * Vec3(normal(random), normal(random), normal(random)); };
      for (int k = 0; k < 100; ++k) {
        const PoseA at = pose(any(0.3), any(0.3));
        const PairEnergy right = sum.at(at);
        size += glm::dot(right.force_kcal_mol_A, right.force_kcal_mol_A);
        torque_size += glm::dot(right.torque_kcal_mol, right.torque_kcal_mol);
        for (int g = 0; g < 2; ++g) {
          const PairEnergy found = grids[g].at(at);
          const Vec3 f = found.force_kcal_mol_A - right.force_kcal_mol_A,
                     t = found.torque_kcal_mol - right.torque_kcal_mol;
          error[g] += glm::dot(f, f);
          torque_error[g] += glm::dot(t, t);
        }
      }
    }
    const bool cubic = interpolation == GridInterpolation::Tricubic;
    CHECK(std::sqrt(error[0] / error[1]) > (cubic ? 2.4 : 1.7));
    CHECK(std::sqrt(error[1] / size) < (cubic ? 0.07 : 0.16));
    CHECK(std::sqrt(torque_error[1] / torque_size) < (cubic ? 0.07 : 0.16));
  }
}

TEST_CASE(
    "force and torque are the negative differences of the felt energy to 1e-3, tricubic everywhere and trilinear "
    "within "
    "cells, in one grid and in a fine grid within a coarse one") {
  const Scene scene = crowd(21, 4);
  const auto coarse = mapsOf(scene, 7.0, 0.6, 4.0), fine = mapsOf(scene, 2.5, 0.3, 4.0);
  for (const bool workspace : {false, true})
    for (const GridInterpolation interpolation : kBoth) {
      EnergyGrid grid = gridOf(scene, coarse, workspace ? fine : nullptr, interpolation);
      std::mt19937 random(21);
      std::normal_distribution<double> normal;
      const auto any = [&](double s) { return s * Vec3(normal(random), normal(random), normal(random)); };
      int right = 0, judged = 0;
      while (judged < 200) {
        const PoseA at = pose(any(1.0), any(1.0));
        const PairEnergy found = grid.at(at);
        if (grid.outside()) continue;
        ++judged;
        // The tricubic sum is rounded to float, about 1e-6 kcal/mol.
        const Difference d = slopeOf(grid, at, interpolation == GridInterpolation::Tricubic ? 1e-3 : 1e-5);
        const double size = 1.0 + glm::length(found.force_kcal_mol_A) + glm::length(found.torque_kcal_mol);
        right += glm::distance(d.force, found.force_kcal_mol_A) + glm::distance(d.torque, found.torque_kcal_mol) <
                 (interpolation == GridInterpolation::Tricubic ? 2e-3 : 1e-3) * size;
      }
      // A step may cross a face of a cell, where the trilinear force jumps.
      CHECK(right >= (interpolation == GridInterpolation::Tricubic ? 200 : 195));
    }
}

TEST_CASE(
    "along 400 steps of 1e-4 A across faces of cells and of the fine grid, the tricubic force changes by less than "
    "0.05 "
    "kcal/mol/A in each step and the trilinear one jumps by more than 0.2 somewhere") {
  const Scene scene = crowd(22, 3);
  const auto coarse = mapsOf(scene, 7.0, 0.6, 4.0), fine = mapsOf(scene, 3.0, 0.3, 4.0);
  for (const GridInterpolation interpolation : kBoth) {
    EnergyGrid grid = gridOf(scene, coarse, fine, interpolation);
    double jump = 0;
    for (double from = -4.0; from < 4.0; from += 0.1) {
      Vec3 before(0.0);
      for (int k = 0; k < 400; ++k) {
        const PairEnergy found = grid.at(pose(Vec3(from + 1e-4 * k, 0.3, 0.2)));
        REQUIRE_FALSE(grid.outside());
        if (k) jump = std::max(jump, glm::distance(before, found.force_kcal_mol_A));
        before = found.force_kcal_mol_A;
      }
    }
    if (interpolation == GridInterpolation::Tricubic)
      CHECK(jump < 0.05);
    else
      CHECK(jump > 0.2);
  }
}

TEST_CASE("no second difference of the tricubic energy exceeds the bounds of the stiffness at 200 poses") {
  const Scene scene = crowd(23, 6);
  const auto coarse = mapsOf(scene, 6.0, 0.5, 4.0), fine = mapsOf(scene, 2.5, 0.3, 4.0);
  std::mt19937 random(23);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  int within = 0;
  for (int k = 0; k < 200; ++k) {
    EnergyGrid grid = gridOf(scene, coarse, fine, GridInterpolation::Tricubic);
    const PoseA at = pose(0.3 * any(), 0.3 * any());
    const PairEnergy found = grid.at(at);
    REQUIRE_FALSE(grid.outside());
    const Vec3 way = glm::normalize(any());
    constexpr double kStep = 1e-5;
    // Differences of the force: the energy's rounding is that of float maps.
    const auto force = [&](double s) { return grid.at({{at.place.A + s * way}, at.orientation}).force_kcal_mol_A; };
    const double along = -glm::dot(force(kStep) - force(-kStep), way) / (2 * kStep);
    const auto torque = [&](double s) {
      return grid.at({at.place, pose({}, s * way).orientation * at.orientation}).torque_kcal_mol;
    };
    const double about = -glm::dot(torque(kStep) - torque(-kStep), way) / (2 * kStep);
    within +=
        along <= found.stiffness_kcal_mol_A2 * 1.01 + 0.3 && about <= found.rotational_stiffness_kcal_mol * 1.01 + 1.0;
  }
  CHECK(within >= 198);  // a step may cross a face, where the curvature jumps
}

TEST_CASE("outside of the box, and for a pose that is no number, there is no energy; the former is flagged") {
  const Scene scene = crowd(31, 3);
  EnergyGrid grid = gridOf(scene, mapsOf(scene, 3.0, 0.5, 4.0), {}, GridInterpolation::Tricubic);
  CHECK(grid.at(pose({})).energy.felt_kcal_mol != 0.0);
  CHECK_FALSE(grid.outside());
  for (const Vec3& at : {Vec3(4, 0, 0), Vec3(0, -9, 0), Vec3(0, 0, 1e9)}) {
    const PairEnergy found = grid.at(pose(at));
    CHECK(grid.outside());
    CHECK(found.energy.felt_kcal_mol == 0.0);
    CHECK(found.force_kcal_mol_A == Vec3(0.0));
    CHECK(found.stiffness_kcal_mol_A2 == 0.0);
  }
  CHECK(grid.at({{Vec3(NAN, 0, 0)}, kNoRotation}).energy.felt_kcal_mol == 0.0);
  CHECK(grid.at({{Vec3(0)}, Quat(NAN, 0, 0, 0)}).energy.felt_kcal_mol == 0.0);
  CHECK_FALSE(grid.outside());
}

TEST_CASE("two atoms in one place give finite energies, folded or not") {
  const Scene crowded = crowd(32, 3);
  for (const double fold : {0.0, 4.0}) {
    const auto maps = mapsOf(crowded, 9.0, 0.5, fold);
    for (const GridInterpolation interpolation : kBoth) {
      EnergyGrid grid = gridOf(crowded, maps, {}, interpolation);
      for (std::size_t k = 0; k < crowded.atoms.size(); k += 9) {
        const Vec3 at = crowded.atoms[k].centre_A;
        if (std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) > 6.5) continue;
        const PairEnergy found = grid.at(pose(at));
        CHECK(std::isfinite(found.energy.felt_kcal_mol));
        CHECK(finite(found.force_kcal_mol_A));
        CHECK(finite(found.torque_kcal_mol));
        CHECK(std::isfinite(found.stiffness_kcal_mol_A2 + found.rotational_stiffness_kcal_mol));
      }
    }
  }
}

TEST_CASE(
    "maps are the same on 1 and on 4 threads; progress rises to 1; a refusal cancels; an exception comes through") {
  const Scene scene = crowd(41, 3);
  const auto box = gridBoxRound(Vec3(-3), Vec3(3), 0.5);
  REQUIRE(box);
  const std::vector<float> sizes = gridSizes(scene.body);
  CHECK(sizes == std::vector<float>{0.6f, 1.6612f, 1.908f});
  std::vector<double> shares;
  const auto one = computeGridMaps(*scene.grid, scene.atoms, *box, sizes, {}, 1, [&](double share) {
    shares.push_back(share);
    return true;
  });
  const auto four = computeGridMaps(*scene.grid, scene.atoms, *box, sizes, {}, 4);
  REQUIRE(one);
  REQUIRE(four);
  CHECK(one->van_der_waals == four->van_der_waals);
  CHECK(one->electrostatic == four->electrostatic);
  CHECK(one->bytes() == 4 * box->count() * sizeof(float));
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.back() == 1.0);
  CHECK_FALSE(computeGridMaps(*scene.grid, scene.atoms, *box, sizes, {}, 2, [](double) { return false; }));
  CHECK_THROWS_AS(runGridWork(100, 3,
                              [](std::size_t k) {
                                if (k == 50) throw std::bad_alloc();
                              },
                              {}),
                  std::bad_alloc);
}

TEST_CASE("1000 evaluations allocate nothing") {
  const Scene scene = crowd(51, 12);
  EnergyGrid grid =
      gridOf(scene, mapsOf(scene, 6.0, 0.5, 4.0), mapsOf(scene, 3.0, 0.4, 4.0), GridInterpolation::Tricubic);
  double sum = 0;
  const long before = test::allocations();
  for (int k = 0; k < 1000; ++k) sum += grid.at(pose(Vec3(0.002 * k, 0, 0))).energy.felt_kcal_mol;
  CHECK(test::allocations() == before);
  CHECK(std::isfinite(sum));
}
