// A probe and bodies in the field of atoms, joined to the hand by the virtual coupling. Oracles: closed forms between two
// atoms, and the energy of another sum over the same pairs at the same poses.
#include "engine/haptics/field/coupled_field.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "tests/haptics/body_paths.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

constexpr double kMinimum_A = 3.82, kDepth_kcal_mol = 0.238;  // of two argon atoms in AMBER

PairAtom argon(const Vec3& at, float charge_e = 0.0f) { return {at, 1.91f, 0.238f, charge_e}; }

std::shared_ptr<const PairField> coupledFieldFieldOf(const std::vector<PairAtom>& atoms,
                                                     const std::vector<PairAtom>& held, double wall_kcal_mol = 1.0) {
  auto out = std::make_shared<PairField>();
  std::vector<Sphere> places;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    places.push_back({atoms[k].centre_A, 1.0});
    out->carriers.push_back(std::uint32_t(k));
  }
  out->places = std::make_shared<const SphereGrid>(std::move(places));
  out->atoms = atoms;
  out->held = held;
  out->model.kind = Dielectric::Distance;
  out->model.wall_kcal_mol = wall_kcal_mol;
  return out;
}

// One argon at the origin, of a small radius, so that the contact does not act in the well, and one at the probe.
CoupledField argonPair(double coupling_kcal_mol_A2, double radius_A = 1.0, double wall_kcal_mol = 1.0) {
  auto probe = referenceMethod().make(test::makeScene({{{0, 0, 0}, radius_A}}), 0.5);
  return CoupledField(std::move(probe), coupledFieldFieldOf({argon({})}, {argon({})}, wall_kcal_mol),
                      {coupling_kcal_mol_A2});
}

// The energy of two argon atoms, unswitched below 8 A, and its slope.
double argonEnergy(double r) {
  const double s = std::pow(kMinimum_A / r, 6.0);
  return kDepth_kcal_mol * (s * s - 2.0 * s);
}
double argonSlope(double r) {
  const double s = std::pow(kMinimum_A / r, 6.0);
  return kDepth_kcal_mol * 12.0 / r * (s - s * s);
}

Response rest(Interaction& felt, const PoseA& hand, int ticks = 400) {
  Response out;
  for (int k = 0; k < ticks; ++k) out = felt.respond(hand);
  return out;
}

struct Crowd {
  std::vector<Sphere> spheres;
  std::vector<PairAtom> atoms, held;
  std::shared_ptr<const HeldBody> body;
};

// A ball of 120 atoms and a chain of 8, with the parameters of carbon and charges up to 0.4 e.
Crowd coupledFieldCrowd(std::uint64_t seed) {
  Crowd out;
  scenes::Random random(seed);
  const auto atom = [&](const Vec3& at) { return PairAtom{at, 1.908f, 0.1094f, float(random.uniform(-0.4, 0.4))}; };
  out.spheres = scenes::cluster(120, seed).spheres;
  for (const Sphere& s : out.spheres) out.atoms.push_back(atom(s.centre_A));
  out.body = test::chainBody(8, seed + 1);
  for (const Sphere& s : out.body->spheres) out.held.push_back(atom(s.centre_A));
  return out;
}

CoupledField coupled(const Crowd& c, double coupling_kcal_mol_A2, double weak_gain = 1.0) {
  auto inner = std::make_unique<ExactBody>(test::makeScene(c.spheres), c.body);
  const VirtualCoupling coupling{coupling_kcal_mol_A2, inner->lever_A(), c.body->reach_A};
  auto field = std::make_shared<PairField>(*coupledFieldFieldOf(c.atoms, c.held));
  field->model.weak_gain = weak_gain;
  return CoupledField(std::move(inner), std::move(field), coupling);
}

double fieldEnergy(PairSum& sum, const PoseA& at) { return sum.at(at).energy.felt_kcal_mol; }

}  // namespace

TEST_CASE(
    "a probe of argon near an argon atom rests where the coupling balances the slope of Lennard-Jones's energy, to "
    "1e-4 A, "
    "and the hand feels that slope") {
  for (const double k : {0.5, 2.0, 40.0})
    for (const double hand_A : {3.7, 3.9, 4.3, 5.0, 6.5}) {
      CAPTURE(k);
      CAPTURE(hand_A);
      CoupledField felt = argonPair(k);
      const Response r = rest(felt, {{Vec3(hand_A, 0, 0)}});
      const double x = r.contact.scp.A.x;
      CHECK_FALSE(r.contact.touching());
      CHECK(r.at_rest);
      // Newton's method from there does not move.
      CHECK(std::abs(k * (x - hand_A) + argonSlope(x)) < 1e-4 * k);
      CHECK(r.contact.displacement_A.x == doctest::Approx(-argonSlope(x) / k).epsilon(1e-3));
      REQUIRE(r.molecular_energy);
      CHECK(r.molecular_energy->parts[EnergyPart::VanDerWaals] == doctest::Approx(argonEnergy(x)).epsilon(1e-4));
      CHECK(r.molecular_energy->coupling_kcal_mol_A2 == k);
      CHECK(r.acts());
    }
}

TEST_CASE(
    "a coupling softer than the well's steepest slope snaps: the probe falls from 5.0 A or more to 4.3 A or less, and "
    "the "
    "hand gets less work back than it did") {
  // The slope of the energy falls by at most 0.34 kcal/mol/A^2, near 4.6 A.
  CoupledField felt = argonPair(0.05);
  Response last = felt.respond({{Vec3(9.0, 0, 0)}});
  double longest_A = 0.0, work = 0.0;
  const auto go = [&](double to) {
    const double from = last.contact.scp.A.x - last.contact.displacement_A.x;
    for (int k = 1; k <= 20'000; ++k) {
      const double was = last.contact.scp.A.x, force = last.contact.displacement_A.x;
      last = felt.respond({{Vec3(from + (to - from) * k / 20'000.0, 0, 0)}});
      longest_A = std::max(longest_A, std::abs(last.contact.scp.A.x - was));
      work +=
          0.05 * 0.5 * (force + last.contact.displacement_A.x) * ((to - from) / 20'000.0);  // of the field on the hand
    }
  };
  go(3.9);
  const double in = work;
  go(9.0);
  CHECK(longest_A < CoupledField::kStep_A + 1e-9);
  CHECK(in > 0.0);      // the hand was drawn in
  CHECK(work < -0.01);  // and did more work on the way out (kcal/mol)
}

TEST_CASE(
    "a stiff coupling gives the work of a way into the well back on the way out, to 1 %, and the energy of the well is "
    "that "
    "work") {
  CoupledField felt = argonPair(40.0);
  double work = 0.0, deepest = 0.0;
  double force = 0.0, at = 9.9;
  felt.respond({{Vec3(at, 0, 0)}});
  const auto go = [&](double to) {
    const double from = at;
    for (int k = 1; k <= 20'000; ++k) {
      const double next = from + (to - from) * k / 20'000.0;
      const Response r = felt.respond({{Vec3(next, 0, 0)}});
      work += 40.0 * 0.5 * (force + r.contact.displacement_A.x) * (next - at);
      force = r.contact.displacement_A.x;
      at = next;
      deepest = std::max(deepest, work);
    }
  };
  go(3.82);
  CHECK(work == doctest::Approx(kDepth_kcal_mol).epsilon(0.01));
  go(9.9);
  CHECK(std::abs(work) < 0.01 * kDepth_kcal_mol);
  CHECK(work < 1e-4);
}

TEST_CASE(
    "in no tick of 24,000 along random paths does the body's motion raise the energy of coupling and field by more "
    "than "
    "0.01 kcal/mol, and it overlaps no atom") {
  for (const std::uint64_t seed : {11u, 12u, 13u}) {
    CAPTURE(seed);
    const Crowd c = coupledFieldCrowd(seed);
    for (const double k : {5.0, 100.0}) {
      CAPTURE(k);
      const double gain = seed == 11u ? 1.0 : seed == 12u ? 3.0 : 8.0;
      CoupledField felt = coupled(c, k, gain);
      PairModel model = coupledFieldFieldOf(c.atoms, c.held)->model;
      model.weak_gain = gain;
      PairSum check(test::makeScene(c.spheres), c.atoms, c.held, model);
      std::optional<PoseA> before;
      double worst = -INFINITY, deepest = -INFINITY;
      int contacts = 0, fields = 0;
      for (const PoseA& hand : test::bodyPath(c.spheres, c.body->reach_A, 4000, seed, 0.02, 0.01, 0.5, 701)) {
        const Response r = felt.respond(hand);
        if (r.contact.fault != Fault::None) {
          before.reset();
          continue;
        }
        REQUIRE(r.body_pose);
        contacts += r.contact.touching();
        fields += std::abs(r.molecular_energy->felt_kcal_mol) > 0.1;
        if (before) {
          const double was = felt.couplingEnergy_kcal_mol(*before) + fieldEnergy(check, *before);
          const double is = felt.couplingEnergy_kcal_mol(*r.body_pose) + fieldEnergy(check, *r.body_pose);
          worst = std::max(worst, is - was);
        }
        before = r.body_pose;
        for (const Sphere& s : c.body->spheres)
          deepest = std::max(deepest, test::deepest_A(c.spheres, s.radius_A,
                                                      r.body_pose->place.A + r.body_pose->orientation * s.centre_A));
      }
      CHECK(contacts > 200);
      CHECK(fields > 1000);
      CHECK(worst < 0.01);
      CHECK(deepest < 1e-9);
      MESSAGE("k = ", k, ": ", felt.rejected(), " ticks taken back, the largest rise ", worst, " kcal/mol");
    }
  }
}

TEST_CASE(
    "20 closed ways of the hand with a body over a crowd of atoms leave the hand no work, at couplings from 2 to 200 "
    "and "
    "at each gain of weak forces that the panel offers") {
  const Crowd c = coupledFieldCrowd(21);
  std::vector<std::pair<double, double>> ways{{2.0, 1.0}, {20.0, 1.0}, {200.0, 1.0}, {2.0, 8.0}, {200.0, 8.0}};
  for (double gain = 1.5; gain <= 8.0; gain += 0.5) ways.emplace_back(20.0, gain);
  for (const auto& [stiffness, gain] : ways) {
    const double k = stiffness;
    CAPTURE(k);
    CAPTURE(gain);
    CoupledField felt = coupled(c, k, gain);
    scenes::Random random(5);
    double total = 0.0;
    for (int loop = 0; loop < 20; ++loop) {
      const Vec3 direction = random.direction(), side = glm::normalize(glm::cross(direction, random.direction()));
      double far = 0.0;
      for (const Sphere& s : c.spheres) far = std::max(far, glm::length(s.centre_A) + 1.5);
      const auto hand = [&](double t) {
        const double angle = 2.0 * std::numbers::pi * t;
        return PoseA{{direction * (far + 9.0 - (9.0 + 0.5 * c.body->reach_A) * 0.5 * (1.0 - std::cos(angle))) +
                      side * (3.0 * std::sin(angle))},
                     glm::angleAxis(0.5 * std::sin(2.0 * angle), side)};
      };
      PoseA at = hand(0.0);
      felt.reset();
      Response last = felt.respond(at);
      for (int n = 1; n <= 6000; ++n) {
        const PoseA next = hand(n / 6000.0);
        const Response r = felt.respond(next);
        total += 0.5 * k * glm::dot(last.contact.displacement_A + r.contact.displacement_A, next.place.A - at.place.A);
        total += 0.5 * k * glm::dot(last.torque_A2 + r.torque_A2, rotationBetween(at.orientation, next.orientation));
        at = next;
        last = r;
      }
      CHECK(total < 0.02 * (loop + 1));
    }
    MESSAGE("k = ", k, ", gain ", gain, ": the hand did ", -total, " kcal/mol in 20 ways");
  }
}

TEST_CASE(
    "the reactions on the atoms are the opposite of the force on the hand, in the field alone and with a contact, and "
    "in the "
    "field each is the force between the pair") {
  const std::vector<PairAtom> atoms{argon({0, 0, 0}, 0.5f), argon({7, 0, 0}, -0.5f)};
  auto probe = referenceMethod().make(test::makeScene({{{0, 0, 0}, 1.5}, {{7, 0, 0}, 1.5}}), 1.4);
  CoupledField felt(std::move(probe), coupledFieldFieldOf(atoms, {argon({}, 0.3f)}), {20.0});
  std::vector<AtomForce> room(felt.maxReactionCount());
  for (const Vec3& hand : {Vec3(3.4, 4, 0), Vec3(1.4, 1.6, 0), Vec3(1.0, 1.0, 0)}) {
    Response r = felt.respond({{Vec3(3.5, 9, 0)}});
    for (int k = 0; k <= 600; ++k) r = felt.respond({{glm::mix(Vec3(3.5, 9, 0), hand, std::min(1.0, k / 300.0))}});
    const std::size_t count = felt.reactions(r, 3.0, 1.0, room);
    Vec3 sum(0.0);
    for (std::size_t k = 0; k < count; ++k) sum += room[k].force_N;
    CAPTURE(hand.y);
    CHECK(glm::distance(sum, -r.total(3.0).force_N) < 1e-9);
    CHECK(r.contact.touching() == (hand.y < 2.0));
    if (r.contact.touching()) continue;
    REQUIRE(count == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      // Distance-dependent dielectric of 4 r, unswitched below 8 A.
      const PairAtom& other = atoms[std::size_t(room[k].atom)];
      const Vec3 to = r.contact.scp.A - other.centre_A;
      const double d = glm::length(to);
      const double slope = argonSlope(d) - 2.0 * 332.0637 * other.charge_e * 0.3 / (4.0 * d * d * d);
      // The energy is below zero, where nothing is bounded.
      const Vec3 expected_N = 3.0 / 20.0 * slope * to / d;
      CHECK(glm::distance(room[k].force_N, expected_N) < 2e-3 * glm::length(expected_N) + 1e-5);
    }
  }
}

TEST_CASE("a hand that jumps by 5 A through the field is followed in steps of at most 0.25 A, and reached") {
  CoupledField felt = argonPair(2.0);
  Response r = rest(felt, {{Vec3(4.5, 0, 0)}});
  Vec3 at = r.contact.scp.A;
  for (int k = 0; k < 200; ++k) {
    r = felt.respond({{Vec3(4.5, 5, 0)}});
    CHECK(glm::distance(at, r.contact.scp.A) <= CoupledField::kStep_A + 1e-12);
    at = r.contact.scp.A;
  }
  CHECK(glm::distance(at, Vec3(4.5, 5, 0)) < 0.05);
}

TEST_CASE("outside of the cut-off the hand feels nothing and the body is at the hand, to the last bit") {
  const Crowd c = coupledFieldCrowd(31);
  CoupledField felt = coupled(c, 20.0);
  for (int k = 0; k < 50; ++k) {
    const PoseA hand{{Vec3(60 + 0.1 * k, 3, 1)}, glm::angleAxis(0.01 * k, Vec3(0, 0, 1))};
    const Response r = felt.respond(hand);
    CHECK(r.contact.displacement_A == Vec3(0.0));
    CHECK(r.torque_A2 == Vec3(0.0));
    CHECK(r.shownBody(hand).place == hand.place);
    CHECK(r.molecular_energy->felt_kcal_mol == 0.0);
  }
}

TEST_CASE(
    "a hand that starts inside an atom gets no force until it has been outside, and a pose of NaN leaves no NaN") {
  CoupledField felt = argonPair(20.0, 1.5);
  Response r = felt.respond({{Vec3(0.2, 0, 0)}});
  CHECK(r.contact.fault == Fault::StartedInside);
  CHECK(r.contact.displacement_A == Vec3(0.0));
  r = rest(felt, {{Vec3(4.5, 0, 0)}}, 50);
  CHECK(r.contact.fault == Fault::None);
  CHECK(r.contact.displacement_A.x < 0.0);
  const Response bad = felt.respond({{Vec3(NAN, 0, 0)}});
  CHECK(bad.contact.fault == Fault::NotFinite);
  CHECK(finite(bad.contact.displacement_A));
  r = rest(felt, {{Vec3(4.5, 0, 0)}}, 50);
  CHECK(finite(r.contact.scp.A));
  CHECK(r.contact.displacement_A.x < 0.0);
}

TEST_CASE("every method and kind of interaction can be felt with forces between atoms, and none without their atoms") {
  const auto scene = test::makeScene({{{0, 0, 0}, 1.7}});
  const auto body = bodyOfSpheres({{{-1, 0, 0}, 1.2}, {{1, 0, 0}, 1.2}});
  for (const Method& method : methods())
    for (const InteractionKind& kind : interactionKinds()) {
      CAPTURE(method.name);
      CAPTURE(kind.name);
      InteractionInput input{.spheres = scene};
      input.touch.method = method.name;
      input.touch.interaction = kind.name;
      input.touch.forces = "all";
      if (kind.holds_body) input.body = body;
      CHECK_FALSE(makeInteraction(input));
      input.pairs = kind.holds_body ? coupledFieldFieldOf({argon({})}, {argon({-1, 0, 0}), argon({1, 0, 0})})
                                    : coupledFieldFieldOf({argon({})}, {argon({})});
      const auto felt = makeInteraction(input);
      REQUIRE(felt);
      const Vec3 at = kind.holds_body ? Vec3(0, 4.2, 0) : Vec3(0, 4.5, 0);
      Response r = felt->respond({{at + Vec3(0, 8, 0)}, kNoRotation});
      for (int k = 0; k < 900; ++k)
        r = felt->respond({{at + Vec3(0, 8.0 * std::max(0.0, 1.0 - k / 300.0), 0)}, kNoRotation});
      REQUIRE(r.molecular_energy);
      CHECK(r.molecular_energy->felt_kcal_mol < -0.1);
      CHECK(r.contact.displacement_A.y < -1e-4);
    }
}
