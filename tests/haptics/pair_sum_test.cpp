// Oracle: all pairs in long double, without lists, cut into nothing but the definition of the energy. Gradients are
// central differences of the oracle's energy.
#include "engine/haptics/field/pair_sum.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>

using namespace moltact;

namespace {

using Real = long double;

// AMBER's argon: lowest energy of 0.238 kcal/mol at 3.82 A.
PairAtom pairSumArgon(const Vec3& at) { return {at, 1.91f, 0.238f, 0.0f}; }
PairAtom charge(const Vec3& at, float e) { return {at, 0.0f, 0.0f, e}; }

PairSum pairSumSumOf(const std::vector<PairAtom>& scene, const std::vector<PairAtom>& body, const PairModel& model) {
  std::vector<Sphere> spheres;
  for (const PairAtom& a : scene) spheres.push_back({a.centre_A, 1.5});
  return PairSum(std::make_shared<const SphereGrid>(std::move(spheres)), scene, body, model);
}

PairModel unbounded(Dielectric kind = Dielectric::Constant, double dielectric = 4.0) {
  PairModel m;
  m.kind = kind;
  m.dielectric = dielectric;
  m.wall_kcal_mol = INFINITY;
  return m;
}

struct PairSumScene {
  std::vector<PairAtom> atoms, body;
};

// A crowd of atoms about 2 A apart in a ball, with a gap of 4 A in its middle for the body.
PairSumScene pairSumCrowd(unsigned seed, int atoms = 900, int held = 12) {
  std::mt19937 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const auto kind = [&](const Vec3& at) {
    return PairAtom{at, float(in(0.6, 2.1)), float(in(0.0, 0.25)), float(in(-0.8, 0.8))};
  };
  PairSumScene out;
  while (int(out.atoms.size()) < atoms) {
    const Vec3 at(in(-14, 14), in(-14, 14), in(-14, 14));
    if (glm::length(at) > 5.0) out.atoms.push_back(kind(at));
  }
  for (int k = 0; k < held; ++k) out.body.push_back(kind(Vec3(in(-2, 2), in(-2, 2), in(-2, 2))));
  return out;
}

PoseA pairSumPose(const Vec3& at, const Vec3& turn = Vec3(0.0)) {
  const double angle = glm::length(turn);
  return {{at}, angle > 0 ? glm::angleAxis(angle, turn / angle) : kNoRotation};
}

struct OracleEnergy {
  Real van_der_waals = 0, electrostatic = 0, felt = 0, size = 0;  // size: the sum of all amounts
};

Real switchOf(Real r, const PairModel& m) {
  const Real c2 = Real(m.cutoff_A) * m.cutoff_A, f2 = Real(m.switch_from_A) * m.switch_from_A;
  const Real u = std::min<Real>(1, std::max<Real>(0, (c2 - r * r) / (c2 - f2)));
  return u * u * (3 - 2 * u);
}

Real dielectricOf(Real r, const PairModel& m) {
  if (m.kind == Dielectric::Constant) return m.dielectric;
  if (m.kind == Dielectric::Distance) return m.dielectric * r;
  return Real(-8.5525) + Real(86.9525) / (1 + Real(7.7839) * std::exp(-Real(0.003627) * Real(86.9525) * r));
}

Real sixth(Real x) { return x * x * x * x * x * x; }

// With a gain of weak forces, the scale of a well whose 5 kcal/mol stay 5, by Newton's method.
Real feltOf(Real energy, const PairModel& m) {
  const Real wall = m.wall_kcal_mol, g = m.weak_gain;
  if (!std::isfinite(m.wall_kcal_mol) || (energy <= 0 && g == 1)) return energy;
  if (energy > 0) return wall * std::asinh(g * energy / wall);
  Real well = 1;
  for (int n = 0; n < 200; ++n) {
    const Real x = 5 * g / well, f = well * std::asinh(x) - 5, slope = std::asinh(x) - x / std::sqrt(1 + x * x);
    well = std::max(well / 4, well - f / slope);
  }
  return well * std::asinh(g * energy / well);
}

OracleEnergy referenceEnergy(const PairSumScene& s, const PairModel& m, const PoseA& at) {
  OracleEnergy out;
  Real nearest = INFINITY;
  const glm::dmat3 turn = glm::mat3_cast(at.orientation);
  for (const PairAtom& b : s.body) {
    const Vec3 place = at.place.A + turn * b.centre_A;
    Real atom = 0;
    for (const PairAtom& a : s.atoms) {
      const Real x = Real(place.x) - a.centre_A.x, y = Real(place.y) - a.centre_A.y, z = Real(place.z) - a.centre_A.z;
      const Real r = std::sqrt(x * x + y * y + z * z);
      if (r >= m.cutoff_A) continue;
      nearest = std::min(nearest, r);
      const Real s6 = sixth((Real(a.half_minimum_A) + b.half_minimum_A) / r);
      const Real lj = switchOf(r, m) * std::sqrt(Real(a.depth_kcal_mol) * b.depth_kcal_mol) * (s6 * s6 - 2 * s6);
      const Real el = switchOf(r, m) * Real(kCoulomb_kcal_A) * a.charge_e * b.charge_e / (r * dielectricOf(r, m));
      out.van_der_waals += lj;
      out.electrostatic += el;
      out.size += std::abs(lj) + std::abs(el);
      atom += lj + el;
    }
    out.felt += feltOf(atom, m);
  }
  REQUIRE(nearest > kMinPair_A);
  return out;
}

}  // namespace

TEST_CASE("two argon atoms have their lowest energy, -0.238 kcal/mol, at 3.82 A, and none at 3.82 / 2^(1/6) A") {
  PairModel model = unbounded();
  PairSum sum = pairSumSumOf({pairSumArgon({})}, {pairSumArgon({})}, model);
  const PairEnergy well = sum.at(pairSumPose({3.82, 0, 0}));
  CHECK(well.energy.parts[EnergyPart::VanDerWaals] == doctest::Approx(-0.238).epsilon(1e-6));
  CHECK(glm::length(well.force_kcal_mol_A) < 1e-6);
  // 72 e / rmin^2 is the curvature of the well.
  CHECK(well.stiffness_kcal_mol_A2 == doctest::Approx(72 * 0.238 / (3.82 * 3.82)).epsilon(0.25));
  CHECK(well.stiffness_kcal_mol_A2 >= 72 * 0.238 / (3.82 * 3.82) * (1 - 1e-5));
  CHECK(std::abs(sum.at(pairSumPose({0, 3.82 / std::pow(2.0, 1.0 / 6), 0})).energy.parts[EnergyPart::VanDerWaals]) <
        1e-6);
  CHECK(sum.at(pairSumPose({0, 0, 10.0})).energy.felt_kcal_mol == 0.0);
  CHECK(sum.at(pairSumPose({0, 0, 3.0})).force_kcal_mol_A.z > 10.0);
  CHECK(sum.at(pairSumPose({0, 0, 5.0})).force_kcal_mol_A.z < 0.0);
}

TEST_CASE("charges of 1 and -1 at 5 A: -16.60, -3.32 and -5.05 kcal/mol in three dielectrics, as by their formulas") {
  const std::vector<PairAtom> plus{charge({}, 1.0f)}, minus{charge({}, -1.0f)};
  const auto energy = [&](const PairModel& m) {
    return pairSumSumOf(plus, minus, m).at(pairSumPose({3, 4, 0})).energy.parts[EnergyPart::Electrostatic];
  };
  CHECK(energy(unbounded()) == doctest::Approx(-332.0637 / (4 * 5)).epsilon(1e-6));
  CHECK(energy(unbounded(Dielectric::Distance)) == doctest::Approx(-332.0637 / (4 * 25)).epsilon(1e-6));
  const double eps = -8.5525 + 86.9525 / (1 + 7.7839 * std::exp(-0.003627 * 86.9525 * 5));
  CHECK(energy(unbounded(Dielectric::MehlerSolmajer)) == doctest::Approx(-332.0637 / (5 * eps)).epsilon(2e-5));
}

TEST_CASE(
    "a charge at 7 A on the axis of a dipole of 0.1 A and one charge has q p / (eps r^2), within the next order") {
  PairSum sum =
      pairSumSumOf({charge({0, 0, -0.05}, -1.0f), charge({0, 0, 0.05}, 1.0f)}, {charge({}, 1.0f)}, unbounded());
  CHECK(sum.at(pairSumPose({0, 0, 7.0})).energy.parts[EnergyPart::Electrostatic] ==
        doctest::Approx(332.0637 * 0.1 / (4 * 49)).epsilon(1e-3));
  CHECK(std::abs(sum.at(pairSumPose({7.0, 0, 0})).energy.parts[EnergyPart::Electrostatic]) < 1e-5);
}

TEST_CASE(
    "a charge at 7 A feels the field (3 (p r) r - p) / (eps r^3) of a dipole of 0.1 A in 50 directions, and the dipole "
    "the torque p x E, within the next order") {
  const std::vector<PairAtom> dipole{charge({0, 0, -0.05}, -1.0f), charge({0, 0, 0.05}, 1.0f)},
      single{charge({}, 1.0f)};
  PairSum on_charge = pairSumSumOf(dipole, single, unbounded()), on_dipole = pairSumSumOf(single, dipole, unbounded());
  const Vec3 p(0, 0, 0.1);
  std::mt19937 random(81);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 50; ++k) {
    const Vec3 r = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
    const double unit = 332.0637 / 4.0;
    const Vec3 force = unit * (3.0 * glm::dot(p, r) * r - p) / (7.0 * 7.0 * 7.0);
    CHECK(glm::distance(on_charge.at(pairSumPose(7.0 * r)).force_kcal_mol_A, force) < 1e-3 * glm::length(force));
    // The field of the charge at the dipole, 7 A from it along r.
    const Vec3 field = unit * r / 49.0, torque = glm::cross(p, field);
    const PairEnergy found = on_dipole.at(pairSumPose(7.0 * r));
    CHECK(glm::distance(found.torque_kcal_mol, torque) < 1e-3 * unit * 0.1 / 49.0);
    CHECK(glm::distance(found.force_kcal_mol_A, -force) < 1e-3 * glm::length(force));
  }
}

TEST_CASE(
    "an infinite row of charges 2 A apart: the force 2 q / (eps a d) (1 + sum 4 pi m d / a K1(2 pi m d / a)) beside "
    "equal "
    "ones, the energy 4 q / (eps a) sum K0(pi m d / a) of odd m beside alternating ones") {
  constexpr double kApart_A = 2.0, kPi = 3.14159265358979;
  constexpr int kHalf = 1500;
  PairModel model = unbounded(Dielectric::Constant, 4.0);
  model.cutoff_A = 2.0 * kHalf * kApart_A;
  model.switch_from_A = model.cutoff_A - 1.0;
  for (const bool alternating : {false, true}) {
    std::vector<PairAtom> row;
    // Half charges at the ends: an alternating row then ends without a net charge.
    for (int k = -kHalf; k <= kHalf; ++k)
      row.push_back(charge({kApart_A * k, 0, 0},
                           float((alternating && k % 2 ? -1.0 : 1.0) * (std::abs(k) == kHalf ? 0.5 : 1.0))));
    PairSum sum = pairSumSumOf(row, {charge({}, 1.0f)}, model);
    for (const double d : {1.0, 1.5, 2.0, 3.0, 4.0}) {
      CAPTURE(alternating);
      CAPTURE(d);
      const PairEnergy found = sum.at(pairSumPose({0, d * 0.6, d * 0.8}));
      double right = 0.0;
      if (alternating) {
        for (int m = 1; m < 40; m += 2) right += std::cyl_bessel_k(0.0, kPi * m * d / kApart_A);
        right *= 332.0637 / 4.0 * 4.0 / kApart_A;
        CHECK(std::abs(found.energy.parts[EnergyPart::Electrostatic] - right) < 1e-4 * right + 2e-4);
      } else {
        for (int m = 1; m < 40; ++m)
          right += 4.0 * kPi * m * d / kApart_A * std::cyl_bessel_k(1.0, 2.0 * kPi * m * d / kApart_A);
        right = 332.0637 / 4.0 * 2.0 / (kApart_A * d) * (1.0 + right);
        CHECK(glm::distance(found.force_kcal_mol_A, right * Vec3(0, 0.6, 0.8)) < 1e-4 * right);
      }
    }
  }
}

namespace {

struct Differences {
  double energy = 0, force = 0, torque = 0;
};

// The greatest differences from the oracle and its differences of energy at random poses, as shares of the sum of the
// amounts of all pairs' energies.
Differences worstDifferences(const PairSumScene& scene, const PairModel& model, unsigned seed, int poses,
                             double shift_A, double turn) {
  PairSum sum = pairSumSumOf(scene.atoms, scene.body, model);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto any = [&](double size) { return size * Vec3(normal(random), normal(random), normal(random)); };
  Differences worst;
  int judged = 0;
  while (judged < poses) {
    const PoseA at = pairSumPose(any(shift_A), any(turn));
    const glm::dmat3 turned = glm::mat3_cast(at.orientation);
    double nearest = INFINITY;
    for (const PairAtom& b : scene.body)
      for (const PairAtom& a : scene.atoms)
        nearest = std::min(nearest, glm::distance(at.place.A + turned * b.centre_A, a.centre_A));
    if (nearest < 1.6) continue;
    ++judged;
    const OracleEnergy right = referenceEnergy(scene, model, at);
    const PairEnergy found = sum.at(at);
    worst.energy = std::max(
        {worst.energy, double(std::abs(right.van_der_waals - found.energy.parts[EnergyPart::VanDerWaals]) / right.size),
         double(std::abs(right.electrostatic - found.energy.parts[EnergyPart::Electrostatic]) / right.size),
         double(std::abs(right.felt - found.energy.felt_kcal_mol) / right.size)});
    constexpr double kStep = 1e-5;
    Vec3 force, torque;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step(0.0);
      step[axis] = kStep;
      const auto felt = [&](const PoseA& p) { return referenceEnergy(scene, model, p).felt; };
      force[axis] = double((felt({{at.place.A - step}, at.orientation}) - felt({{at.place.A + step}, at.orientation})) /
                           (2 * kStep));
      torque[axis] = double((felt({at.place, pairSumPose({}, -step).orientation * at.orientation}) -
                             felt({at.place, pairSumPose({}, step).orientation * at.orientation})) /
                            (2 * kStep));
    }
    // The steepest pair's scale: an energy's gradient is at most about 12 / r of it.
    const double size = double(right.size) * 4.0;
    worst.force = std::max(worst.force, glm::distance(force, found.force_kcal_mol_A) / size);
    worst.torque = std::max(worst.torque, glm::distance(torque, found.torque_kcal_mol) / size);
  }
  return worst;
}

}  // namespace

TEST_CASE(
    "energy, force and torque agree with all pairs in long double and its differences to 2e-6 of the sum of their "
    "amounts, at 60 poses of 6 crowds in 3 dielectrics, with and without bounded walls") {
  for (const Dielectric kind : {Dielectric::Constant, Dielectric::Distance, Dielectric::MehlerSolmajer})
    for (const double wall : {double(INFINITY), 1.0}) {
      const unsigned seed = 20 + unsigned(kind) * 2 + (wall == 1.0);
      CAPTURE(seed);
      PairModel model = unbounded(kind);
      model.wall_kcal_mol = wall;
      const Differences worst = worstDifferences(pairSumCrowd(seed), model, seed, 60, 0.3, 0.5);
      CHECK(worst.energy < 2e-6);
      CHECK(worst.force < 2e-6);
      CHECK(worst.torque < 2e-6);
    }
}

TEST_CASE(
    "with weak forces felt 1.5, 3 and 8 times as strong, energy, force and torque are those of the felt energy to 2e-6 "
    "of the sum of the pairs' amounts times the gain") {
  for (const double gain : {1.5, 3.0, 8.0}) {
    CAPTURE(gain);
    PairModel model = unbounded(Dielectric::Distance, 4.0);
    model.wall_kcal_mol = 1.0;
    model.weak_gain = gain;
    const Differences worst = worstDifferences(pairSumCrowd(41), model, 41, 60, 0.3, 0.5);
    CHECK(worst.energy < 2e-6 * gain);
    CHECK(worst.force < 2e-6 * gain);
    CHECK(worst.torque < 2e-6 * gain);
  }
}

TEST_CASE(
    "force and torque are the differences of energy in long double to 1e-6 of the sum of the pairs' amounts at 10 000 "
    "random poses in any orientation") {
  // 120 atoms from 4 to 9 A from the middle, five held.
  std::mt19937 random(71);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  PairSumScene scene;
  const auto kind = [&](const Vec3& at) {
    return PairAtom{at, float(in(0.6, 2.1)), float(in(0.0, 0.25)), float(in(-0.8, 0.8))};
  };
  while (scene.atoms.size() < 120) {
    const Vec3 at(in(-9, 9), in(-9, 9), in(-9, 9));
    if (glm::length(at) > 4.0 && glm::length(at) < 9.0) scene.atoms.push_back(kind(at));
  }
  for (int k = 0; k < 5; ++k) scene.body.push_back(kind(Vec3(in(-2, 2), in(-2, 2), in(-2, 2))));
  for (const Dielectric dielectric : {Dielectric::Constant, Dielectric::MehlerSolmajer}) {
    PairModel model = unbounded(dielectric);
    model.wall_kcal_mol = 1.0;
    const Differences worst = worstDifferences(scene, model, 72 + unsigned(dielectric), 5000, 0.8, 2.0);
    CHECK(worst.energy < 2e-6);
    CHECK(worst.force < 1e-6);
    CHECK(worst.torque < 1e-6);
    MESSAGE("5000 poses: energy ", worst.energy, ", force ", worst.force, ", torque ", worst.torque);
  }
}

TEST_CASE(
    "no second difference of the energy along 60 translations and rotations exceeds the bounds of the stiffness") {
  for (const unsigned seed : {31u, 32u, 33u}) {
    CAPTURE(seed);
    const PairSumScene scene = pairSumCrowd(seed);
    PairModel model;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 60; ++k) {
      PairSum sum = pairSumSumOf(scene.atoms, scene.body, model);
      const auto any = [&] { return Vec3(normal(random), normal(random), normal(random)); };
      const PoseA at = pairSumPose(0.2 * any(), 0.3 * any());
      const PairEnergy found = sum.at(at);
      const Vec3 way = glm::normalize(any());
      constexpr double kStep = 1e-4;
      const Real here = referenceEnergy(scene, model, at).felt;
      const auto curvature = [&](const PoseA& one, const PoseA& other) {
        return double((referenceEnergy(scene, model, one).felt + referenceEnergy(scene, model, other).felt - 2 * here) /
                      (Real(kStep) * kStep));
      };
      const double along =
          curvature({{at.place.A - kStep * way}, at.orientation}, {{at.place.A + kStep * way}, at.orientation});
      const double about = curvature({at.place, pairSumPose({}, -kStep * way).orientation * at.orientation},
                                     {at.place, pairSumPose({}, kStep * way).orientation * at.orientation});
      CHECK(along <= found.stiffness_kcal_mol_A2 * 1.001 + 0.01);
      CHECK(about <= found.rotational_stiffness_kcal_mol * 1.001 + 0.01);
    }
  }
}

TEST_CASE(
    "on a path of 3000 ticks with jumps, lists kept from tick to tick give what new lists give, and at most an "
    "eighth of them and one are renewed in a tick without a jump") {
  const PairSumScene scene = pairSumCrowd(41, 2500, 40);
  PairModel model;
  PairSum kept = pairSumSumOf(scene.atoms, scene.body, model);
  std::mt19937 random(41);
  std::normal_distribution<double> normal;
  Vec3 at(0.0), turn(0.0);
  double worst = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    const bool jump = tick % 500 == 499;
    at += (jump ? 3.0 : 0.02) * Vec3(normal(random), normal(random), normal(random));
    turn += 0.005 * Vec3(normal(random), normal(random), normal(random));
    if (glm::length(at) > 8) at = Vec3(0.0);
    const PairEnergy found = kept.at(pairSumPose(at, turn));
    if (!jump && at != Vec3(0.0)) CHECK(kept.renewedLists() <= 40 / 8 + 1 + 40 * (tick == 0));
    if (tick % 50) continue;
    PairSum fresh = pairSumSumOf(scene.atoms, scene.body, model);
    const PairEnergy right = fresh.at(pairSumPose(at, turn));
    const double size = 1.0 + std::abs(right.energy.felt_kcal_mol);
    worst = std::max(
        {worst, std::abs(found.energy.felt_kcal_mol - right.energy.felt_kcal_mol) / size,
         glm::distance(found.force_kcal_mol_A, right.force_kcal_mol_A) / (1.0 + glm::length(right.force_kcal_mol_A))});
  }
  CHECK(worst < 5e-6);
}

TEST_CASE("the loop for this processor gives the bits of the plain one, in 3 dielectrics, over 300 blocks") {
  std::mt19937 random(51);
  const auto in = [&](double low, double high) {
    return float(std::uniform_real_distribution<double>(low, high)(random));
  };
  std::vector<PairBlock> blocks(300);
  for (PairBlock& b : blocks)
    for (int k = 0; k < PairBlock::kLanes; ++k) {
      b.x[k] = in(-11, 11), b.y[k] = in(-11, 11), b.z[k] = in(-11, 11);
      b.charge_e[k] = in(-1, 1), b.half_minimum_A[k] = in(0, 2), b.root_depth[k] = in(0, 0.5);
    }
  for (const Dielectric kind : {Dielectric::Constant, Dielectric::Distance, Dielectric::MehlerSolmajer}) {
    const PairConstants constants(unbounded(kind));
    PairTerms one, other;
    const PairRun all{blocks.data(), 300};
    const PairOwn own({.half_minimum_A = 1.9f, .depth_kcal_mol = 0.09f, .charge_e = 0.4f}, Vec3(0.1, 0.2, 0.3));
    for (const auto loop : {&PairKernel::slope, &PairKernel::curvature}) {
      one = other = {};
      (pairKernel(kind).*loop)(&all, 1, constants, own, one);
      (plainPairKernel(kind).*loop)(&all, 1, constants, own, other);
      CHECK(std::memcmp(&one, &other, sizeof one) == 0);
    }
    CHECK(std::isfinite(one.energy[EnergyPart::Electrostatic]));
  }
}

TEST_CASE("blocks that state the bounds of their distances give the bits of blocks that do not, from 0.2 to 13 A") {
  std::mt19937 random(52);
  const auto in = [&](double low, double high) {
    return float(std::uniform_real_distribution<double>(low, high)(random));
  };
  std::normal_distribution<double> normal;
  std::vector<PairBlock> blocks(300);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double near_A = 0.2 + 0.0425 * double(b);
    for (int k = 0; k < PairBlock::kLanes; ++k) {
      const Vec3 way = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
      blocks[b].set(k, (near_A + double(in(0, 0.05))) * way, {{}, in(0, 2), in(0, 0.25), in(-1, 1)});
    }
  }
  std::vector<PairBlock> bounded = blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    bounded[b].nearest_A = float(0.2 + 0.0425 * double(b) - 1e-4);
    bounded[b].farthest_A = float(0.2 + 0.0425 * double(b) + 0.05 + 1e-4);
  }
  const PairRun plain{blocks.data(), 300}, stated{bounded.data(), 300};
  for (const Dielectric kind : {Dielectric::Constant, Dielectric::Distance, Dielectric::MehlerSolmajer}) {
    PairModel model;  // with the switch from 8 to 10 A
    model.kind = kind;
    const PairConstants constants(model);
    for (const double off_A : {0.0, 0.4, 1.0}) {
      const PairOwn own({.half_minimum_A = 1.9f, .depth_kcal_mol = 0.09f, .charge_e = 0.4f}, Vec3(0, off_A, 0));
      for (const auto loop : {&PairKernel::slope, &PairKernel::curvature}) {
        PairTerms one, other;
        (pairKernel(kind).*loop)(&plain, 1, constants, own, one);
        (pairKernel(kind).*loop)(&stated, 1, constants, own, other);
        CHECK(std::memcmp(&one, &other, sizeof one) == 0);
      }
    }
  }
}

TEST_CASE("3000 atoms within 1 A, more than a list has room for, give what the oracle gives") {
  PairSumScene scene;
  std::mt19937 random(61);
  std::uniform_real_distribution<double> in(-0.5, 0.5);
  for (int k = 0; k < 3000; ++k) scene.atoms.push_back(charge(Vec3(in(random), in(random), in(random)), 0.01f));
  scene.body = {charge({}, 1.0f)};
  const PairModel model = unbounded();
  PairSum sum = pairSumSumOf(scene.atoms, scene.body, model);
  const PoseA at = pairSumPose({4, 0, 0});
  CHECK(sum.at(at).energy.parts[EnergyPart::Electrostatic] ==
        doctest::Approx(double(referenceEnergy(scene, model, at).electrostatic)).epsilon(1e-5));
  CHECK(sum.listedPairs() == 0);
}

TEST_CASE("two atoms in one place, an infinite pose and an empty body give finite numbers, and a far one none") {
  PairSum sum = pairSumSumOf({pairSumArgon({}), charge({1, 0, 0}, 1.0f)}, {pairSumArgon({}), charge({1, 0, 0}, -1.0f)},
                             PairModel{});
  for (const Vec3& at : {Vec3(0.0), Vec3(1e-30, 0, 0), Vec3(0.4, 0, 0), Vec3(1e9, 0, 0)}) {
    const PairEnergy found = sum.at(pairSumPose(at));
    CHECK(std::isfinite(found.energy.felt_kcal_mol));
    CHECK(finite(found.force_kcal_mol_A));
    CHECK(finite(found.torque_kcal_mol));
    CHECK(std::isfinite(found.stiffness_kcal_mol_A2 + found.rotational_stiffness_kcal_mol));
  }
  CHECK(sum.at(pairSumPose({NAN, 0, 0})).energy.felt_kcal_mol == 0.0);
  CHECK(sum.at({{Vec3(0.0)}, Quat(NAN, 0, 0, 0)}).energy.felt_kcal_mol == 0.0);
  CHECK(sum.at(pairSumPose({1e9, 0, 0})).energy.felt_kcal_mol == 0.0);
  CHECK(pairSumSumOf({pairSumArgon({})}, {}, PairModel{}).at(pairSumPose({})).energy.felt_kcal_mol == 0.0);
}
