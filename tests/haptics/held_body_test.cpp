// A rigid body in the hand: the sum of the contacts of its atoms, against closed forms and against separate probes.
#include <doctest/doctest.h>

#include <random>

#include "engine/bench/scenes.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/wrapped_interaction.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

using Atoms = std::vector<std::uint32_t>;

constexpr double kFelt_A = 1.6 - kBodyOverlap_A;

// A sphere of 3 A at the zero point, which the hand feels, and beside it a bent body of three atoms that it holds.
const std::vector<Sphere> kSpheres{{{0, 0, 0}, 3.0}, {{10, 0, 0}, 1.6}, {{12, 0, 0}, 1.6}, {{12, 2, 0}, 1.6}};
const Atoms kHeld{1, 2, 3};

std::shared_ptr<const SphereGrid> scene() { return std::make_shared<const SphereGrid>(kSpheres, kHeld); }

RigidBody::MakeSphere spheres(const Method& method, std::shared_ptr<const SphereGrid> spheres) {
  return [&method, spheres = std::move(spheres)](double radius_A) { return method.make(spheres, radius_A); };
}

Quat anyRotation(std::mt19937& random) {
  std::normal_distribution<double> any;
  return glm::normalize(Quat(any(random), any(random), any(random), any(random)));
}

}  // namespace

TEST_CASE("a body is its atoms round their middle, each 0.5 A smaller; more than 5000, or none, are no body") {
  const auto body = heldBody(kSpheres, kHeld);
  REQUIRE(body);
  CHECK(body->atoms == kHeld);
  CHECK(glm::distance(body->middle.A, Vec3(34.0 / 3, 2.0 / 3, 0)) < 1e-12);
  Vec3 sum(0.0);
  for (const Sphere& b : body->spheres) {
    sum += b.centre_A;
    CHECK(b.radius_A == doctest::Approx(1.1));
  }
  CHECK(glm::length(sum) < 1e-12);
  CHECK(body->reach_A == doctest::Approx(glm::length(Vec3(4.0 / 3, 2.0 / 3, 0)) + 1.1));
  CHECK_FALSE(heldBody(kSpheres, Atoms{}));
  CHECK_FALSE(heldBody(kSpheres, Atoms{7}));
  std::vector<Sphere> many(5001, Sphere{{0, 0, 0}, 1.0});
  Atoms all(5001);
  for (std::uint32_t i = 0; i < 5001; ++i) all[i] = i;
  CHECK_FALSE(heldBody(many, all));
  all.pop_back();
  CHECK(heldBody(many, all));
}

TEST_CASE("a body of one atom is a probe of its radius in each method, over 1500 poses, and is never turned") {
  const scenes::Scene cluster = scenes::cluster(20, 5);
  const auto grid = test::makeScene(cluster.spheres);
  const std::vector<Sphere> atom{{{4, 5, 6}, cluster.probe_A + kBodyOverlap_A}};
  const auto body = heldBody(atom, Atoms{0});
  for (const Method& method : methods()) {
    CAPTURE(std::string(method.name));
    RigidBody felt(body, spheres(method, grid));
    const auto tracker = method.make(grid, body->spheres[0].radius_A);
    int touching = 0, different = 0;
    for (const Vec3& place : scenes::walk(cluster, 1500, 7)) {
      const Response r = felt.respond({{place}, glm::angleAxis(place.x, glm::normalize(Vec3(1, 2, 3)))});
      const Response alone = tracker->respond({{place}});
      const Contact& c = alone.contact;
      touching += c.touching();
      different += r.contact.displacement_A != c.displacement_A || r.contact.energy_A2 != c.energy_A2 ||
                   r.contact.atoms != c.atoms || r.contact.feature != c.feature || r.torque_A2 != Vec3(0.0) ||
                   r.stiffness_factor != alone.stiffness_factor;
    }
    CHECK(touching > 400);
    CHECK(different == 0);
  }
}

TEST_CASE(
    "force, torque and energy of three atoms on one sphere are their springs' sums in closed form, at 2000 poses") {
  std::mt19937 random(20261123);
  CAPTURE("seed 20261123");
  const auto body = heldBody(kSpheres, kHeld);
  RigidBody felt(body, spheres(referenceMethod(), scene()));
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int pressed[4] = {};
  double worst = 0.0;
  for (int n = 0; n < 2000; ++n) {
    const Quat turned = anyRotation(random);
    const Vec3 way = glm::normalize(Vec3(unit(random), unit(random), unit(random)) + Vec3(0, 0, 1e-3));
    // Straight in, as far as its middle's place allows none of its atoms to pass the sphere's.
    felt.reset();
    const Vec3 place = way * (4.1 + unit(random));
    for (double out_A = 12.0; out_A > 0.0; out_A -= 0.05) felt.respond({{place + way * out_A}, turned});
    const Response r = felt.respond({{place}, turned});
    Vec3 force(0.0), torque(0.0);
    double energy = 0.0;
    int springs = 0;
    for (const Sphere& b : body->spheres) {
      const Vec3 lever = turned * b.centre_A, p = place + lever;
      const double deep = 3.0 + kFelt_A - glm::length(p);
      if (deep <= 0.0) continue;
      ++springs;
      const Vec3 pull = glm::normalize(p) * deep;
      force += pull, torque += glm::cross(lever, pull), energy += 0.5 * deep * deep;
    }
    ++pressed[springs];
    REQUIRE(r.contact.fault == Fault::None);
    worst = std::max({worst, glm::distance(r.contact.displacement_A, force), glm::distance(r.torque_A2, torque),
                      std::abs(r.contact.energy_A2 - energy)});
    CHECK(r.stiffness_factor == std::max(1, springs));
    CHECK(glm::distance(r.contact.scp.A, place + force / double(std::max(1, springs))) < 1e-9);
    CHECK(r.contact.touching() == (springs > 0));
    if (springs) CHECK(r.contact.atoms == std::array<std::int32_t, 3>{0, -1, -1});
  }
  CHECK(worst < 1e-8);
  for (const int k : {0, 1, 2, 3}) CHECK(pressed[k] > 50);
}

TEST_CASE(
    "a body that begins with one atom inside is felt only once all of it is outside at once, and what is no pose "
    "gives no force") {
  RigidBody felt(heldBody(kSpheres, kHeld), spheres(referenceMethod(), scene()));
  const auto at = [&](double x) { return felt.respond({{Vec3(x, 0, 0)}, kNoRotation}); };
  CHECK(at(5.0).contact.fault == Fault::StartedInside);  // its first atom is 1.3 A to the left of its middle
  CHECK_FALSE(at(5.0).acts());
  CHECK(at(4.0).contact.fault == Fault::StartedInside);
  CHECK(at(9.0).contact.fault == Fault::None);
  const Response back = at(5.0);
  CHECK(back.contact.fault == Fault::None);
  CHECK(back.contact.displacement_A.x ==
        doctest::Approx(3.0 + kFelt_A - std::hypot(5.0 - 4.0 / 3, 2.0 / 3)).epsilon(0.02));
  felt.reset();
  CHECK_FALSE(at(5.0).acts());
  CHECK(felt.respond({{Vec3(9, 0, 0)}, Quat(0, 0, 0, 0)}).contact.fault == Fault::NotFinite);
  CHECK_FALSE(felt.respond({{Vec3(5, 0, 0)}, Quat(std::nan(""), 0, 0, 0)}).acts());
  CHECK_FALSE(felt.respond({{Vec3(std::nan(""), 0, 0)}, kNoRotation}).acts());
}

TEST_CASE(
    "a body meets a scene where the first of its atoms does: at the place that each of 300 sweeps tells its least gap "
    "is 0") {
  std::mt19937 random(7);
  CAPTURE("seed 7");
  const scenes::Scene cluster = scenes::cluster(40, 3);
  const auto spheres = test::makeScene(cluster.spheres);
  const auto body = heldBody(kSpheres, kHeld);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto gap_A = [&](const Vec3& place, const Quat& turned) {
    double least = 1e300;
    for (const Sphere& b : body->spheres)
      for (const Sphere& c : cluster.spheres)
        least = std::min(least, glm::distance(place + turned * b.centre_A, c.centre_A) - b.radius_A - c.radius_A);
    return least;
  };
  int met = 0;
  for (int n = 0; n < 300; ++n) {
    const Quat turned = anyRotation(random);
    const Vec3 middle = 0.5 * (spheres->low_A() + spheres->high_A());
    const Vec3 from = middle + 40.0 * glm::normalize(Vec3(unit(random), unit(random), unit(random)));
    const Vec3 to = middle + Vec3(unit(random), unit(random), unit(random)) * 8.0;
    const Hit hit = sweep(*spheres, HandShape(*body, turned), from, to);
    if (hit.sphere < 0) {
      CHECK(gap_A(to, turned) > -1e-6);
      continue;
    }
    ++met;
    CHECK(std::abs(gap_A(from + (to - from) * hit.t, turned)) < 1e-6);
    for (const double part : {0.2, 0.5, 0.8, 0.95}) CHECK(gap_A(from + (to - from) * (hit.t * part), turned) > -1e-9);
  }
  CHECK(met > 150);
  CHECK(sweep(*spheres, HandShape(1.4), Vec3(50, 0, 0), Vec3(0)).t == sweep(*spheres, 1.4, Vec3(50, 0, 0), Vec3(0)).t);
}

TEST_CASE("a body follows spheres that move where its method does: a sphere that comes by 0.5 A pushes it by 0.5 A") {
  std::vector<Sphere> to = kSpheres;
  to[0].centre_A.x = 0.5;
  const auto motion = SphereMotion::make(kSpheres, to, 10, kHeld);
  REQUIRE(motion);
  // Turned round, so that the bent end points away and the first atom touches with its middle on the axis.
  const auto pull_A = [&](RigidBody& felt) {
    return felt.respond({{Vec3(3.0 + kFelt_A + 4.0 / 3, 2.0 / 3, 0)}, kNoRotation}).contact.displacement_A.x;
  };
  for (const Method& method : methods()) {
    CAPTURE(std::string(method.name));
    RigidBody felt(heldBody(kSpheres, kHeld), spheres(method, scene()));
    felt.respond({{Vec3(20, 0, 0)}, kNoRotation});
    pull_A(felt);
    CHECK(felt.setMotion(motion->get()) == method.follows_motion);
    if (!isReference(method)) continue;
    felt.advanceTo(1.0);
    CHECK(pull_A(felt) == doctest::Approx(0.5).epsilon(1e-6));
  }
}

// Doubles the pull of a sphere: what a friction or a limit in depth is to a body.
class Doubled final : public WrappedInteraction {
 public:
  using WrappedInteraction::WrappedInteraction;
  Response respond(const PoseA& pose) noexcept override {
    Response out = inner().respond(pose);
    out.contact.displacement_A *= 2.0;
    out.contact.energy_A2 *= 2.0;
    return out;
  }
};

TEST_CASE("what is put round each sphere of a body is felt in its force, torque and energy: all twice as much") {
  const auto grid = scene();
  const auto plain = spheres(referenceMethod(), grid);
  RigidBody one(heldBody(kSpheres, kHeld), plain);
  RigidBody two(heldBody(kSpheres, kHeld), [&](double radius_A) { return std::make_unique<Doubled>(plain(radius_A)); });
  for (const double x : {9.0, 5.0, 4.8}) {
    const PoseA pose{{Vec3(x, 0.3, 0)}, kNoRotation};
    const Response a = one.respond(pose), b = two.respond(pose);
    CHECK(b.contact.displacement_A == 2.0 * a.contact.displacement_A);
    CHECK(b.torque_A2 == 2.0 * a.torque_A2);
    CHECK(b.contact.energy_A2 == 2.0 * a.contact.energy_A2);
    CHECK((glm::length(a.torque_A2) > 0.1) == (x < 9.0));
  }
}

TEST_CASE("an orientation of length 1 + 4e-4 turns a body as the one of length 1 does: levers do not grow with it") {
  RigidBody exact(heldBody(kSpheres, kHeld), spheres(referenceMethod(), scene()));
  RigidBody longer(heldBody(kSpheres, kHeld), spheres(referenceMethod(), scene()));
  const Quat turned = glm::angleAxis(0.7, glm::normalize(Vec3(1, 2, 3)));
  int felt = 0;
  for (double x = 9.0; x > 3.7; x -= 0.05) {
    const Response a = exact.respond({{Vec3(x, 0.3, 0)}, turned});
    const Response b = longer.respond({{Vec3(x, 0.3, 0)}, turned * (1.0 + 4e-4)});
    CHECK(glm::length(a.contact.displacement_A - b.contact.displacement_A) < 1e-9);
    CHECK(glm::length(a.torque_A2 - b.torque_A2) < 1e-9);
    felt += a.acts();
  }
  CHECK(felt > 10);
}

TEST_CASE("memory that all spheres of a body share is counted once, and so are the atoms that they model") {
  const scenes::Scene cluster = scenes::cluster(200, 5);
  const auto spheres = test::makeScene(cluster.spheres);
  const auto body = heldBody(kSpheres, kHeld);
  TouchSetup touch;
  touch.interaction = "springs";
  const auto felt = makeInteraction({.spheres = spheres, .touch = touch, .body = body});
  felt->respond({{Vec3(1e3)}, kNoRotation});
  const std::size_t one = referenceMethod().make(spheres, 1.1)->memoryUsage().bytes;
  CHECK(felt->memoryUsage().bytes < spheres->bytes() + 3 * (one - spheres->bytes()) + 1000);
  for (double x = 40.0; x > 0.0; x -= 0.1) {
    felt->respond({{Vec3(x, 0, 0)}, kNoRotation});
    CHECK(felt->memoryUsage().atoms_modelled <= 200);
  }
}
