// The oracle of the chart of energies against closed forms and differences.
#include "engine/bench/energies/double_sum.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace moltact;

namespace {

std::shared_ptr<const SphereGrid> placesOf(const std::vector<PairAtom>& atoms) {
  std::vector<Sphere> out;
  for (const PairAtom& a : atoms) out.push_back({a.centre_A, 1.0});
  return std::make_shared<const SphereGrid>(std::move(out));
}

}  // namespace

TEST_CASE("two argon atoms have their well of 0.238 kcal/mol at 3.82 A, and no force there, to 1e-7") {
  const std::vector<PairAtom> argon{{Vec3(0.0), 1.91f, 0.238f, 0.0f}};
  bench::DoubleSum sum(placesOf(argon), argon, argon, std::numeric_limits<double>::infinity(), false);
  const PairEnergy well = sum.at({{Vec3(2.0 * 1.91f, 0, 0)}});
  CHECK(well.energy.felt_kcal_mol == doctest::Approx(-double(0.238f)).epsilon(1e-7));
  CHECK(glm::length(well.force_kcal_mol_A) < 1e-7);
}

TEST_CASE(
    "force and torque are the differences of the energy to 1e-5, with a cut-off and lists and without either, and "
    "equal "
    "PairSum's to 1e-4") {
  std::mt19937 random(5);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<PairAtom> atoms, body;
  while (atoms.size() < 400) {
    const Vec3 at(in(-12, 12), in(-12, 12), in(-12, 12));
    if (glm::length(at) > 5.0) atoms.push_back({at, 1.8f, 0.1f, float(in(-0.5, 0.5))});
  }
  for (int k = 0; k < 6; ++k) body.push_back({Vec3(in(-2, 2), in(-2, 2), in(-2, 2)), 1.7f, 0.1f, float(in(-0.5, 0.5))});
  const auto scene = placesOf(atoms);
  for (const bool lists : {false, true}) {
    bench::DoubleSum sum(scene, atoms, body, lists ? 10.0 : std::numeric_limits<double>::infinity(), lists);
    PairSum program(scene, atoms, body, {});
    for (int k = 0; k < 30; ++k) {
      const PoseA at{{Vec3(in(-1, 1), in(-1, 1), in(-1, 1))}, glm::angleAxis(in(0, 2), glm::normalize(Vec3(1, k, 2)))};
      const PairEnergy found = sum.at(at);
      const auto felt = [&](const Vec3& shift, const Vec3& turn) {
        const double angle = glm::length(turn);
        return sum
            .at({{at.place.A + shift},
                 (angle > 0 ? glm::angleAxis(angle, turn / angle) : kNoRotation) * at.orientation})
            .energy.felt_kcal_mol;
      };
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 step(0.0);
        step[axis] = 1e-4;
        CHECK(std::abs((felt(-step, {}) - felt(step, {})) / 2e-4 - found.force_kcal_mol_A[axis]) <
              1e-6 + 1e-5 * glm::length(found.force_kcal_mol_A));
        CHECK(std::abs((felt(Vec3(0.0), -step) - felt(Vec3(0.0), step)) / 2e-4 - found.torque_kcal_mol[axis]) <
              1e-6 + 1e-5 * glm::length(found.torque_kcal_mol));
      }
      if (!lists) continue;
      const PairEnergy same = program.at(at);
      CHECK(glm::distance(same.force_kcal_mol_A, found.force_kcal_mol_A) <
            1e-4 * (1 + glm::length(found.force_kcal_mol_A)));
      CHECK(std::abs(same.energy.felt_kcal_mol - found.energy.felt_kcal_mol) <
            1e-4 * (1 + std::abs(found.energy.felt_kcal_mol)));
    }
  }
}
