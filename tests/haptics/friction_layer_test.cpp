// The layer of friction (engine/haptics/friction.h) against closed forms on a single sphere, and its energy on random
// paths.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/bench/scenes.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/friction.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "tests/haptics/body_paths.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

std::unique_ptr<FrictionLayer> layer(const std::vector<Sphere>& spheres, double probe_A, const Friction& friction,
                                     std::shared_ptr<const Roughness> roughness = nullptr) {
  const auto scene = test::makeScene(spheres);
  return std::make_unique<FrictionLayer>(referenceMethod().make(scene, probe_A), scene, nullptr, std::move(roughness),
                                         friction);
}

Response frictionLayerAt(Interaction& felt, const Vec3& place) { return felt.respond({{place}, kNoRotation}); }

// Along and against the normal of a contact on a single sphere.
struct Load {
  double drag = 0.0, normal = 0.0;
};
Load loadOf(const Contact& c) {
  const double normal = glm::dot(c.displacement_A, c.normals[0]);
  return {glm::length(c.displacement_A - c.normals[0] * normal), normal};
}

}  // namespace

TEST_CASE("with a coefficient of 0 every method answers to the last bit as without the layer") {
  const scenes::Scene scene = scenes::cluster(20, 5);
  const auto spheres = test::makeScene(scene.spheres);
  for (const Method& method : methods()) {
    CAPTURE(method.name);
    const auto bare = method.make(spheres, scene.probe_A);
    FrictionLayer none(method.make(spheres, scene.probe_A), spheres, nullptr, nullptr, {0.0, 0.5});
    int touching = 0, different = 0;
    for (const Vec3& place : scenes::walk(scene, 1000, 5)) {
      const Contact a = frictionLayerAt(*bare, place).contact, b = frictionLayerAt(none, place).contact;
      touching += a.touching();
      different += !(a == b);
    }
    CHECK(touching > 100);
    CHECK(different == 0);
  }
}

TEST_CASE(
    "on a sphere of 3 A the contact rests where the hand is, seen from it, at the angle of friction off the normal: by "
    "the law of sines, to 1e-9 A in 600 places") {
  constexpr double kRadius_A = 3.0, kMu = 0.4;
  const auto felt = layer({{{0, 0, 0}, kRadius_A}}, 0.0, {kMu, 0.0});
  frictionLayerAt(*felt, {0, 0, 4});
  frictionLayerAt(*felt, {0, 0, 2.0});
  const double phi = std::atan(kMu);
  double worst_A = 0.0, worst_ratio = 0.0;
  int slid = 0;
  for (int k = 1; k <= 600; ++k) {
    const double turned = 0.002 * k, r = 2.0;
    const Vec3 hand = r * Vec3(std::sin(turned), 0.0, std::cos(turned));
    const Contact c = frictionLayerAt(*felt, hand).contact;
    // The greatest angle at the centre between hand and contact: R / sin(pi - asin) = r / sin(phi).
    const double most = std::asin(kRadius_A * std::sin(phi) / r) - phi;
    const double lag = std::min(turned, most);
    const Vec3 rests = kRadius_A * Vec3(std::sin(turned - lag), 0.0, std::cos(turned - lag));
    worst_A = std::max(worst_A, glm::distance(c.scp.A, rests));
    if (turned <= most + 0.002) continue;
    ++slid;
    const Load load = loadOf(c);
    worst_ratio = std::max(worst_ratio, std::abs(load.drag / load.normal - kMu));
  }
  CHECK(slid > 300);
  CHECK(worst_A < 1e-9);
  CHECK(worst_ratio < 1e-9);
}

TEST_CASE("a hand so near the centre that it lies in the cone of friction holds the contact wherever it moves") {
  // sin(phi) R = 0.371 x 3 A = 1.11 A.
  const auto felt = layer({{{0, 0, 0}, 3.0}}, 0.0, {0.4, 0.0});
  frictionLayerAt(*felt, {0, 0, 4});
  for (int k = 0; k <= 40; ++k) frictionLayerAt(*felt, {0, 0, 4.0 - 0.08 * k});
  const Vec3 stuck = frictionLayerAt(*felt, {0, 0, 0.8}).contact.scp.A;
  for (int k = 0; k < 100; ++k) {
    const Vec3 hand = 0.3 * Vec3(std::sin(0.06 * k), std::cos(0.1 * k) - 1.0, 0.0) + Vec3(0, 0, 0.8);
    CHECK(glm::distance(frictionLayerAt(*felt, hand).contact.scp.A, stuck) < 1e-9);
  }
}

TEST_CASE(
    "to and fro on a wall the hand gives twice the drag times the way less the stretch of the spring: the hysteresis "
    "of "
    "Dahl's model with exponent 0, to 1e-6") {
  constexpr double kWall_A = 1e7, kMu = 0.3, kDeep_A = 1.0, kHalf_A = 2.0;
  const auto felt = layer({{{0, 0, -kWall_A}, kWall_A}}, 0.0, {kMu, 0.0});
  Vec3 hand(0, 0, 1);
  frictionLayerAt(*felt, hand);
  const auto go = [&](double x) {
    double worked = 0.0;
    Vec3 force = frictionLayerAt(*felt, hand).contact.displacement_A;
    const Vec3 from = hand;
    // A multiple of the stretch per step, so that no step slips in part: 2 mu N / 200.
    const int steps = int(std::lround(std::abs(x - from.x) / (2.0 * kMu * kDeep_A / 200.0)));
    for (int k = 1; k <= steps; ++k) {
      const Vec3 next(from.x + (x - from.x) * k / steps, 0.0, -kDeep_A);
      const Vec3 now = frictionLayerAt(*felt, next).contact.displacement_A;
      worked -= 0.5 * glm::dot(force + now, next - hand);
      hand = next, force = now;
    }
    return worked;
  };
  hand.z = -kDeep_A;
  frictionLayerAt(*felt, hand);
  go(kHalf_A);
  double worked = 0.0;
  for (int k = 0; k < 5; ++k) worked += go(-kHalf_A) + go(kHalf_A);
  const double drag = kMu * kDeep_A;
  CHECK(worked == doctest::Approx(5 * 2.0 * drag * (2.0 * kHalf_A - 2.0 * drag)).epsilon(3e-3));
}

TEST_CASE(
    "stick and slip of 0.5: the drag rises to 0.45 of what presses, falls to 0.3, and a way of 6 A along a wall has "
    "one "
    "slip per 0.15 A") {
  constexpr double kWall_A = 1e7;
  const auto felt = layer({{{0, 0, -kWall_A}, kWall_A}}, 0.0, {0.3, 0.5});
  frictionLayerAt(*felt, {0, 0, 1});
  frictionLayerAt(*felt, {0, 0, -1});
  int slips = 0;
  double most = 0.0, least_after = 1.0;
  for (int k = 1; k <= 60000; ++k) {
    const Load load = loadOf(frictionLayerAt(*felt, {1e-4 * k, 0, -1}).contact);
    most = std::max(most, load.drag / load.normal);
    if (felt->slipped()) {
      ++slips;
      least_after = std::min(least_after, load.drag / load.normal);
    }
  }
  CHECK(most == doctest::Approx(0.45).epsilon(1e-3));
  CHECK(least_after == doctest::Approx(0.3).epsilon(1e-6));
  CHECK(std::abs(slips - int((6.0 - 0.45) / 0.15 + 1)) <= 1);
}

TEST_CASE(
    "a stuck contact goes with its atom: the hand moved as the atom feels the same force in every tick, and beside a "
    "resting hand the spring stretches by the atom's way") {
  const std::vector<Sphere> from{{{0, 0, 0}, 1.7}, {{8, 0, 0}, 1.7}};
  const Vec3 way(0.3, 0.2, 0.0);
  const std::vector<Sphere> to{{way, 1.7}, {{8, 0, 0}, 1.7}};
  const auto motion = SphereMotion::make(from, to, 100);
  REQUIRE(motion);
  for (const bool follows : {true, false}) {
    const auto felt = layer(from, 1.4, {0.5, 0.0});
    const auto deep = [&](double z) { return frictionLayerAt(*felt, {0.05, 0, z}); };
    deep(4);
    const Contact before = deep(1.6).contact;
    REQUIRE(felt->setMotion(motion->get()));
    double distance_A = 0.0, force_A = 0.0;
    for (int k = 1; k <= 100; ++k) {
      felt->advanceTo(k / 100.0);
      const Vec3 moved = way * (k / 100.0);
      const Contact c = frictionLayerAt(*felt, Vec3(0.05, 0, 1.6) + (follows ? moved : Vec3(0.0))).contact;
      distance_A = std::max(distance_A, glm::distance(c.scp.A, before.scp.A + moved));
      force_A =
          std::max(force_A, glm::distance(c.displacement_A, before.displacement_A + (follows ? Vec3(0.0) : moved)));
    }
    CHECK(distance_A < 1e-6);
    CHECK(force_A < 1e-6);
  }
}

TEST_CASE(
    "over 20 atoms with jumps, in 20 random walks: the contact never moves so that the spring stores more than the "
    "hand "
    "put in, with stick and slip and a rough and a smooth half") {
  const scenes::Scene scene = scenes::cluster(20, 5);
  auto halves = std::make_shared<Roughness>(scene.spheres.size(), 0.25f);
  for (std::size_t i = 0; i < halves->size(); i += 2) (*halves)[i] = 1.75f;
  int touching = 0, slips = 0, gains = 0, softened = 0;
  double worst_A2 = 0.0, taken_A2 = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Friction friction{0.1 * double(seed % 10 + 1), seed % 2 ? 0.5 : 0.0};
    const auto felt = layer(scene.spheres, scene.probe_A, friction, halves);
    std::mt19937 random(seed);
    Vec3 scp(0.0);
    double share = 1.0;  // of the spring's stiffness
    bool first = true;
    std::size_t k = 0;
    for (const Vec3& place : scenes::walk(scene, 2000, seed)) {
      // A lost tick now and then, and a few lost in a row.
      if (++k % 50 < random() % 8) continue;
      const Response now = frictionLayerAt(*felt, place);
      // The energy of the spring if the contact had stayed: the rest is what the friction takes.
      const double stayed = 0.5 * share * glm::dot(scp - place, scp - place);
      if (!first && now.contact.touching()) {
        ++touching;
        slips += felt->slipped();
        const double gained = now.contact.energy_A2 - stayed;
        gains += gained > 1e-9;
        worst_A2 = std::max(worst_A2, gained);
        if (gained < 0.0) taken_A2 -= gained;
      }
      scp = now.contact.scp.A;
      const double length = glm::distance(scp, place);
      share = now.contact.touching() && length > 1e-6 ? glm::length(now.contact.displacement_A) / length : 1.0;
      softened += share < 0.999;
      first = false;
    }
  }
  MESSAGE(touching << " ticks in contact, " << slips << " slips, " << gains << " gains of at most " << worst_A2
                   << " A2, " << softened << " ticks softened, taken " << taken_A2 << " A2");
  CHECK(touching > 10000);
  CHECK(slips > 1000);
  CHECK(gains == 0);
  CHECK(softened < touching / 20);
}

TEST_CASE(
    "passing from a smooth to a rough atom across their crease, the coefficient of sliding goes from 0.1 to 0.6 over "
    "values "
    "between, and no step of the hand by 0.0005 A changes the force by more than 0.01 A") {
  // Two atoms, pressed by a hand on a line along them.
  const std::vector<Sphere> spheres{{{-1.5, 0, 0}, 3.0}, {{1.5, 0, 0}, 3.0}};
  const auto texture = std::make_shared<Roughness>(Roughness{0.25f, 1.5f});
  const auto felt = layer(spheres, 0.0, {0.4, 0.0}, texture);
  frictionLayerAt(*felt, {-2, 0, 5});
  Contact before = frictionLayerAt(*felt, {-2, 0, 1.2}).contact;
  double step_A = 0.0, first = 0.0, last = 0.0, between = 0.0;
  for (int k = 0; k <= 8000; ++k) {
    const Contact c = frictionLayerAt(*felt, {-2.0 + 5e-4 * k, 0, 1.2}).contact;
    const Pushes pushes = pushesAlong(c, c.displacement_A);
    double rough = 0.0;
    for (std::size_t n = 0; n < 3; ++n)
      if (c.atoms[n] >= 0) rough += pushes.along[n] * 0.4 * double((*texture)[std::size_t(c.atoms[n])]);
    CHECK(glm::length(pushes.rest) <= rough * (1.0 + 1e-9));
    const double sliding = rough / pushes.sum();
    step_A = std::max(step_A, glm::distance(c.displacement_A, before.displacement_A));
    if (k == 0) first = sliding;
    if (c.feature == Feature::Circle) between = std::max(between, std::min(sliding - 0.1, 0.6 - sliding));
    last = sliding;
    before = c;
  }
  CHECK(first == doctest::Approx(0.1));
  CHECK(last == doctest::Approx(0.6));
  CHECK(between > 0.1);  // both atoms bear
  CHECK(step_A < 0.01);
}

TEST_CASE(
    "a body of two atoms pressed flat on a wall resists being turned about the normal: by the coefficient times what "
    "each "
    "contact presses times its lever, to 1e-3, and turned to and fro it takes energy") {
  constexpr double kWall_A = 1e6, kMu = 0.4, kDeep_A = 0.5, kLever_A = 2.0;
  InteractionInput input{.spheres = test::makeScene({{{0, 0, -kWall_A}, kWall_A}}),
                         .body = bodyOfSpheres({{{-kLever_A, 0, 0}, 1.0}, {{kLever_A, 0, 0}, 1.0}})};
  input.touch.interaction = "exact-body";
  input.touch.friction = kMu;
  const auto felt = makeInteraction(input);
  const auto turned = [&](double angle, double z) {
    return felt->respond({{Vec3(0, 0, z)}, glm::angleAxis(angle, Vec3(0, 0, 1))});
  };
  turned(0.0, 3.0);
  for (int k = 0; k <= 50; ++k) turned(0.0, 1.0 - kDeep_A * k / 50);
  double worked_A2 = 0.0, torque = 0.0;
  Response last;
  double angle = 0.0;
  const auto go = [&](double to) {
    const double from = angle;
    for (int k = 1; k <= 400; ++k) {
      const double next = from + (to - from) * k / 400;
      last = turned(next, 1.0 - kDeep_A);
      worked_A2 -= 0.5 * (torque + last.torque_A2.z) * (next - angle);
      torque = last.torque_A2.z;
      angle = next;
    }
  };
  go(1.0);
  const double most = kMu * kDeep_A * kLever_A;  // both contacts together press with kDeep_A
  CHECK(last.contact.displacement_A.z == doctest::Approx(kDeep_A).epsilon(1e-3));
  CHECK(last.torque_A2.z == doctest::Approx(-most).epsilon(1e-3));
  worked_A2 = 0.0;
  for (int k = 0; k < 5; ++k) go(-1.0), go(1.0);
  // The stretch of the rotational spring, whose stiffness is the square of the body's radius of gyration.
  const double stretch = most / (kLever_A * kLever_A);
  CHECK(worked_A2 == doctest::Approx(5 * 2.0 * most * (2.0 - 2.0 * stretch)).epsilon(0.01));
  // The reactions are the opposite of the force.
  std::vector<AtomForce> room(felt->maxReactionCount());
  Vec3 sum(0.0);
  const std::size_t count = felt->reactions(last, 2.0, 1.0, room);
  for (std::size_t k = 0; k < count; ++k) sum += room[k].force_N;
  CHECK(glm::distance(sum, -last.total(2.0).force_N) < 1e-9);
}

TEST_CASE(
    "a body of three atoms on 20 random paths over 20 atoms, moved and turned: no tick stores more energy than the "
    "hand "
    "put in since the last") {
  const std::vector<Sphere> atoms = scenes::cluster(20, 5).spheres;
  InteractionInput input{.spheres = test::makeScene(atoms),
                         .body = bodyOfSpheres({{{-2, 0, 0}, 1.0}, {{2, 0, 0}, 1.2}, {{0, 1, 1}, 0.8}})};
  input.touch.interaction = "exact-body";
  const ExactBody bare(input.spheres, input.body);
  const double lever2 = bare.lever_A() * bare.lever_A();
  int touching = 0, gains = 0;
  double worst_A2 = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    input.touch.friction = 0.1 * double(seed % 8 + 1);
    input.touch.stick_slip = seed % 2 ? 0.5 : 0.0;
    const auto felt = makeInteraction(input);
    std::optional<Response> before;
    PoseA last;
    bool coupling_slipped = false;
    for (const PoseA& pose : test::bodyPath(atoms, input.body->reach_A, 1000, seed, 0.02, 0.01, 0.5)) {
      const Response now = felt->respond(pose);
      // Beyond 2 rad the rotational spring slips and pulls to another orientation until the body is free again.
      if (before && before->body_pose)
        coupling_slipped |= glm::length(rotationBetween(pose.orientation, before->body_pose->orientation)) > 1.9;
      if (!now.contact.touching()) coupling_slipped = false;
      if (before && before->body_pose && before->contact.touching() && now.contact.touching() && !coupling_slipped) {
        ++touching;
        // Energy of the springs had the body stayed, softened as it was.
        const auto energy = [&](const PoseA& hand) {
          const Vec3 way = before->body_pose->place.A - hand.place.A;
          const Vec3 turn = rotationBetween(hand.orientation, before->body_pose->orientation);
          return 0.5 * (glm::dot(way, way) + lever2 * glm::dot(turn, turn));
        };
        const double whole = energy(last), share = whole > 1e-9 ? before->contact.energy_A2 / whole : 1.0;
        const double gained = now.contact.energy_A2 - share * energy(pose);
        gains += gained > 1e-7;
        worst_A2 = std::max(worst_A2, gained);
      }
      before = now;
      last = pose;
    }
  }
  MESSAGE(touching << " ticks in contact, " << gains << " gains of at most " << worst_A2 << " A2");
  CHECK(touching > 2000);
  CHECK(gains == 0);
}
