// The energy of a held body by parts. Oracle: the definition of the energy of a pair in double, over all pairs.
#include "engine/haptics/field/pair_shares.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>

#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/field/pair_sum.h"

using namespace moltact;

namespace {

// Lennard-Jones and Coulomb with a dielectric of 4 r, switched off between 8 and 10 A.
EnergyByPart pairEnergy(const PairAtom& a, const PairAtom& b, double r) {
  EnergyByPart out;
  if (r >= 10.0) return out;
  const double u = std::min(1.0, (100.0 - r * r) / 36.0), s = u * u * (3.0 - 2.0 * u);
  const double depth = std::sqrt(double(a.depth_kcal_mol) * double(b.depth_kcal_mol)),
               six = std::pow((double(a.half_minimum_A) + double(b.half_minimum_A)) / r, 6.0);
  out[EnergyPart::VanDerWaals] = s * depth * (six * six - 2.0 * six);
  out[EnergyPart::Electrostatic] = s * 332.0637 * double(a.charge_e) * double(b.charge_e) / (4.0 * r * r);
  return out;
}

struct PairSharesCrowd {
  std::shared_ptr<PairField> field = std::make_shared<PairField>();
  std::vector<std::uint32_t> group_of_carrier;
};

// 400 atoms in 37 groups about a body of 9 atoms.
PairSharesCrowd pairSharesCrowd() {
  std::mt19937 random(11);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const auto kind = [&](const Vec3& at) {
    return PairAtom{at, float(in(0.6, 2.1)), float(in(0.0, 0.25)), float(in(-0.8, 0.8))};
  };
  PairSharesCrowd out;
  std::vector<Sphere> places;
  while (out.field->atoms.size() < 400) {
    const Vec3 at(in(-14, 14), in(-14, 14), in(-14, 14));
    if (glm::length(at) < 4.0) continue;
    out.field->carriers.push_back(std::uint32_t(out.field->atoms.size()));
    out.group_of_carrier.push_back(std::uint32_t(7 * (out.field->atoms.size() % 37)));
    out.field->atoms.push_back(kind(at));
    places.push_back({at, 1.0});
  }
  out.field->places = std::make_shared<const SphereGrid>(std::move(places));
  for (int k = 0; k < 9; ++k) out.field->held.push_back(kind(Vec3(in(-1.5, 1.5), in(-1.5, 1.5), in(-1.5, 1.5))));
  out.field->model.kind = Dielectric::Distance;
  out.field->model.dielectric = 4.0;
  return out;
}

}  // namespace

TEST_CASE(
    "the energies of 9 held atoms and of 37 groups are those of all their pairs to 1e-4, and both add up to the energy "
    "of the direct sum, in 20 poses") {
  const PairSharesCrowd c = pairSharesCrowd();
  PairShares shares(c.field, c.group_of_carrier);
  PairSum sum(c.field->places, c.field->atoms, c.field->held, c.field->model);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-1.5, 1.5), turn(-3.0, 3.0);
  for (int round = 0; round < 20; ++round) {
    const PoseA pose{{Vec3(shift(random), shift(random), shift(random))},
                     glm::normalize(Quat(turn(random), turn(random), turn(random), turn(random)))};
    shares.at(pose);
    std::map<std::uint32_t, EnergyByPart> by_group;
    std::vector<EnergyByPart> by_held(9);
    for (std::size_t k = 0; k < 9; ++k)
      for (std::size_t i = 0; i < c.field->atoms.size(); ++i) {
        const Vec3 at = pose.place.A + pose.orientation * c.field->held[k].centre_A;
        const EnergyByPart e =
            pairEnergy(c.field->held[k], c.field->atoms[i], glm::distance(at, c.field->atoms[i].centre_A));
        by_group[c.group_of_carrier[i]] += e;
        by_held[k] += e;
      }
    // Every part that the program knows: one without its line in pairEnergy() fails here.
    const auto same = [](const EnergyShare& one, const EnergyByPart& e) {
      for (const EnergyPartInfo& part : energyParts()) {
        CAPTURE(std::string(part.name));
        CHECK(one.parts[part.part] == doctest::Approx(e[part.part]).epsilon(1e-4).scale(1.0));
      }
    };
    REQUIRE(shares.held().size() == 9);
    for (std::size_t k = 0; k < 9; ++k) same(shares.held()[k], by_held[k]);
    double groups = 0.0;
    std::uint32_t before = 0;
    for (const EnergyShare& one : shares.groups()) {
      CHECK((one.index == 0 || one.index > before));
      before = one.index;
      same(one, by_group.at(one.index));
      groups += one.total_kcal_mol();
    }
    const MolecularEnergy whole = sum.at(pose).energy;
    CHECK(groups == doctest::Approx(whole.total_kcal_mol()).epsilon(1e-4).scale(1.0));
    double felt = 0.0;
    for (const EnergyShare& one : shares.held())
      felt += feltEnergy(one.total_kcal_mol(), c.field->model.wall_kcal_mol).value;
    CHECK(felt == doctest::Approx(whole.felt_kcal_mol).epsilon(1e-4).scale(1.0));
    PairModel bare = c.field->model;
    bare.wall_kcal_mol = INFINITY;
    PairSum unbounded(c.field->places, c.field->atoms, c.field->held, bare);
    const Vec3 force = unbounded.at(pose).force_kcal_mol_A;
    CHECK(glm::distance(shares.force_kcal_mol_A(), force) < 1e-4 * (1.0 + glm::length(force)));
  }
}

TEST_CASE("the pairs above 0.5 kcal/mol are those of the definition; a pose that is not finite has no energy") {
  const PairSharesCrowd c = pairSharesCrowd();
  PairShares shares(c.field, c.group_of_carrier);
  const PoseA pose{{Vec3(3.0, -1.0, 1.5)}};
  shares.at(pose);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> wanted;
  for (std::uint32_t k = 0; k < 9; ++k)
    for (std::uint32_t i = 0; i < c.field->atoms.size(); ++i) {
      const double e = pairEnergy(
          c.field->held[k], c.field->atoms[i],
          glm::distance(pose.place.A + c.field->held[k].centre_A, c.field->atoms[i].centre_A))[EnergyPart::VanDerWaals];
      if (e >= 0.5) wanted[{k, i}] = e;
    }
  const std::vector<NearPair> found = shares.pairsAbove(0.5);
  REQUIRE(wanted.size() >= 3);
  REQUIRE(found.size() == wanted.size());
  for (const NearPair& pair : found) {
    REQUIRE(wanted.contains({pair.held, pair.scene}));
    CHECK(pair.van_der_waals_kcal_mol == doctest::Approx(wanted[{pair.held, pair.scene}]).epsilon(1e-4));
  }
  shares.at({{Vec3(NAN, 0.0, 0.0)}});
  CHECK(shares.groups().empty());
  CHECK(shares.held()[0].total_kcal_mol() == 0.0);
}

TEST_CASE(
    "a held atom's energy is felt unchanged below zero and as E0 asinh(E / E0) above: 1 kcal/mol as 0.881, 10 as "
    "2.998, "
    "1000 as 7.601; the function rises everywhere, and its derivatives are its difference quotients") {
  CHECK(feltEnergy(-3.0, 1.0).value == -3.0);
  CHECK(feltEnergy(0.0, 1.0).value == 0.0);
  CHECK(feltEnergy(1.0, 1.0).value == doctest::Approx(0.881374).epsilon(1e-5));
  CHECK(feltEnergy(10.0, 1.0).value == doctest::Approx(2.998223).epsilon(1e-5));
  CHECK(feltEnergy(1000.0, 1.0).value == doctest::Approx(7.600902).epsilon(1e-5));
  CHECK(feltEnergy(1000.0, INFINITY).value == 1000.0);
  CHECK(feltEnergy(4.0, 2.0).value == doctest::Approx(2.0 * 1.443635).epsilon(1e-5));
  double before = -1e300;
  for (double e = -4.0; e < 50.0; e += 0.37) {
    const FeltEnergy here = feltEnergy(e, 1.5), next = feltEnergy(e + 1e-5, 1.5), last = feltEnergy(e - 1e-5, 1.5);
    CHECK(here.value > before);
    before = here.value;
    CHECK(here.slope == doctest::Approx((next.value - last.value) / 2e-5).epsilon(1e-5));
    CHECK(here.curvature == doctest::Approx((next.slope - last.slope) / 2e-5).epsilon(1e-4).scale(1.0));
  }
}

TEST_CASE(
    "with a gain of 4 a weak energy is felt 4 times, a well of 5 kcal/mol as 5 and one of 10 as 6.06; at 0 value, "
    "slope "
    "and curvature are continuous, the function rises everywhere, and a gain of 1 is the function without one") {
  const FeltFunction four(1.0, 4.0), one(1.0, 1.0);
  CHECK(four.at(-0.001).value == doctest::Approx(-0.004).epsilon(1e-4));
  CHECK(four.at(-5.0).value == doctest::Approx(-5.0).epsilon(1e-9));
  CHECK(four.at(-10.0).value == doctest::Approx(-6.0602).epsilon(1e-4));
  for (const double e : {-7.0, -0.3, 0.0, 0.4, 30.0}) CHECK(one.at(e).value == feltEnergy(e, 1.0).value);
  CHECK(FeltFunction(INFINITY, 4.0).at(-3.0).value == -3.0);
  for (double gain = 1.0; gain <= 8.0; gain += 0.5) {
    CAPTURE(gain);
    const FeltFunction felt(1.0, gain);
    CHECK(felt.at(-5.0).value == doctest::Approx(-5.0).epsilon(1e-9));
    for (const double side : {-1e-9, 1e-9}) {
      CHECK(felt.at(side).value == doctest::Approx(gain * side));
      CHECK(felt.at(side).slope == doctest::Approx(gain));
      CHECK(std::abs(felt.at(side).curvature) < 1e-5);
    }
    double before = -1e300;
    for (double e = -40.0; e < 50.0; e += 0.37) {
      const FeltEnergy here = felt.at(e), next = felt.at(e + 1e-5), last = felt.at(e - 1e-5);
      CHECK(here.value > before);
      before = here.value;
      CHECK(here.slope == doctest::Approx((next.value - last.value) / 2e-5).epsilon(1e-4));
      CHECK(here.curvature == doctest::Approx((next.slope - last.slope) / 2e-5).epsilon(1e-3).scale(1.0));
    }
  }
}
