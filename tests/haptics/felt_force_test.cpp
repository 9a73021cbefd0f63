// Force as a physical quantity: reactions on atoms, the stiffness that bounds the force's gradient, and the sum of
// contact and field.
#include "engine/haptics/felt_force.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/bench/scenes.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/methods.h"
#include "tests/haptics/fields.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

constexpr double kSpring_N_per_A = 1.3;

// How far the reactions to an answer are from the opposite of its force.
double missing_N(const Interaction& felt, const Response& answer, double field_share = 1.0) {
  std::vector<AtomForce> room(felt.maxReactionCount());
  const std::size_t count = felt.reactions(answer, kSpring_N_per_A, field_share, room);
  REQUIRE(count <= room.size());
  Vec3 sum = answer.total(kSpring_N_per_A, field_share).force_N;
  for (std::size_t k = 0; k < count; ++k) {
    CHECK(room[k].atom >= 0);
    sum += room[k].force_N;
  }
  return glm::length(sum);
}

std::shared_ptr<const HeldBody> rod() {
  std::vector<Sphere> spheres;
  std::vector<std::uint32_t> all;
  for (std::uint32_t k = 0; k < 8; ++k) spheres.push_back({Vec3(1.2 * k, 0.3 * (k % 2), 0), 1.7}), all.push_back(k);
  return heldBody(spheres, all);
}

}  // namespace

TEST_CASE(
    "the reactions on the atoms sum to the opposite of the force to 1e-9 N, over 2000 poses: each method, a body of "
    "eight atoms, and a field of three atoms beside a contact with half of its force") {
  const scenes::Scene scene = scenes::cluster(20, 5);
  const auto spheres = test::makeScene(scene.spheres);
  const auto over = [&](Interaction& felt, double field_share) {
    double worst = 0.0;
    int acted = 0;
    for (const Vec3& place : scenes::walk(scene, 2000, 5)) {
      const Response answer = felt.respond({{place}, glm::angleAxis(0.3 * place.x, glm::normalize(Vec3(1, 2, 3)))});
      acted += answer.acts();
      worst = std::max(worst, missing_N(felt, answer, field_share));
    }
    CHECK(acted > 300);
    CHECK(worst < 1e-9);
  };
  for (const Method& method : methods()) {
    CAPTURE(std::string(method.name));
    over(*method.make(spheres, scene.probe_A), 1.0);
  }
  RigidBody body(rod(), [&](double radius_A) { return referenceMethod().make(spheres, radius_A); });
  over(body, 1.0);
  ExactBody exact(spheres, rod());
  over(exact, 1.0);
  test::LennardJones field(
      referenceMethod().make(spheres, scene.probe_A), {},
      {{0, scene.spheres[0].centre_A}, {1, scene.spheres[1].centre_A}, {2, scene.spheres[2].centre_A}});
  over(field, 0.5);
}

TEST_CASE(
    "in the crease of two equal atoms each bears force / (2 cos) along its own normal, on one atom all of it, and a "
    "drag along the surface is shared as the pushes are") {
  // Both spheres of radius 3 with the probe, 2 A from the middle on either side; the SCP lies sqrt(5) over the line.
  const double height = std::sqrt(5.0);
  const auto felt = referenceMethod().make(test::makeScene({{{-2, 0, 0}, 1.6}, {{2, 0, 0}, 1.6}}), 1.4);
  for (double z = 9.0; z > 1.8; z -= 0.01) felt->respond({{{0, 0, z}}});
  const Response crease = felt->respond({{{0, 0, 1.8}}});
  REQUIRE(crease.contact.feature == Feature::Circle);
  std::array<AtomForce, 3> room;
  REQUIRE(felt->reactions(crease, 2.0, 1.0, room) == 2);
  const double force_N = 2.0 * (height - 1.8), cosine = height / 3.0;
  for (const AtomForce& a : std::span(room).first(2))
    CHECK(glm::length(a.force_N) == doctest::Approx(force_N / (2.0 * cosine)).epsilon(1e-9));
  CHECK(room[0].atom == 0);
  CHECK(room[0].force_N.x == doctest::Approx(-room[1].force_N.x));
  CHECK(room[0].force_N.x < 0.0);  // it is pushed away from the other
  CHECK(room[0].force_N.z < 0.0);
  // The same with 0.3 A of drag along the crease.
  Contact dragged = crease.contact;
  dragged.displacement_A.y += 0.3;
  REQUIRE(contactReactions(dragged, 2.0, room) == 2);
  for (const AtomForce& a : std::span(room).first(2)) CHECK(a.force_N.y == doctest::Approx(-0.3));
  Contact one{.scp = {}, .atoms = {7, -1, -1}, .feature = Feature::Sphere, .displacement_A = {0, 0, 0.5}};
  one.normals[0] = {0, 0, 1};
  REQUIRE(contactReactions(one, 2.0, room) == 1);
  CHECK(room[0].atom == 7);
  CHECK(room[0].force_N == Vec3(0, 0, -1.0));
}

TEST_CASE(
    "no small step of the hand is opposed by more than the stiffness says, and no small rotation: over 3000 poses of a "
    "body in both ways, of a probe with the penalty method, and in the field of three atoms") {
  std::mt19937 random(20261124);
  CAPTURE("seed 20261124");
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&] { return glm::normalize(Vec3(unit(random), unit(random), unit(random)) + Vec3(1e-3)); };
  const scenes::Scene scene = scenes::cluster(12, 5);
  const auto spheres = test::makeScene(scene.spheres);
  RigidBody body(rod(), [&](double radius_A) { return findMethod("penalty")->make(spheres, radius_A); });
  ExactBody exact(spheres, rod());
  const auto penalty = findMethod("penalty")->make(spheres, scene.probe_A);
  test::LennardJones field(
      std::make_unique<test::OpenSpace>(), {},
      {{0, scene.spheres[0].centre_A}, {1, scene.spheres[1].centre_A}, {2, scene.spheres[2].centre_A}});
  constexpr double kStep = 1e-6;
  for (Interaction* felt : std::initializer_list<Interaction*>{&body, &exact, penalty.get(), &field}) {
    int steps = 0, over = 0, tight = 0;
    felt->respond({{Vec3(200, 0, 0)}});
    for (const Vec3& place : scenes::walk(scene, 3000, 5)) {
      const Quat turned = glm::angleAxis(unit(random), any());
      const Response a = felt->respond({{place}, turned});
      if (!a.acts()) continue;
      const FeltForce at = a.total(kSpring_N_per_A);
      const Vec3 way = any();
      const FeltForce moved = felt->respond({{place + kStep * way}, turned}).total(kSpring_N_per_A);
      const FeltForce rotated = felt->respond({{place}, glm::angleAxis(kStep, way) * turned}).total(kSpring_N_per_A);
      ++steps;
      const double opposed = -glm::dot(moved.force_N - at.force_N, way) / kStep;
      over += opposed > at.stiffness_N_per_A * 1.001 + 1e-3;
      tight += opposed > 0.5 * at.stiffness_N_per_A;
      over += -glm::dot(rotated.torque_N_A - at.torque_N_A, way) / kStep > at.rotational_stiffness_N_A * 1.001 + 1e-3;
    }
    CHECK(steps > 500);
    CHECK(over <= steps / 250);  // where an atom comes into contact, or a body leaps, within the step
    CHECK(tight > 0);
  }
}

TEST_CASE(
    "force, torque and energy of an answer are those of springs and field together; in a device's space at 0.25 A/mm "
    "force is the opposite of the energy's slope") {
  Response answer{.contact = {}, .torque_A2 = {0, 0, 3}, .stiffness_factor = 2.0, .rotational_A2 = 5.0};
  answer.contact.displacement_A = {1, 0, 0};
  answer.contact.energy_A2 = 0.5;
  answer.field = FeltForce{{0, 2, 0}, {0, 0, 1}, -4.0, 6.0, 7.0};
  const FeltForce sum = answer.total(0.5, 0.5);
  CHECK(sum == FeltForce{{0.5, 1, 0}, {0, 0, 2}, 0.25 - 2.0, 1.0 + 3.0, 2.5 + 3.5});
  Workspace workspace;
  workspace.A_per_mm = 0.25;
  workspace.rotation = glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(Vec3(1, 2, 3))));
  test::LennardJones field(std::make_unique<test::OpenSpace>(), {}, {{0, Vec3(0.0)}});
  const auto at = [&](const Vec3& mm) {
    return inDevice(*field.respond({workspace.toMolecule(PointMm{mm})}).field, workspace);
  };
  const Vec3 place(9, 8, -7);
  constexpr double kStep_mm = 1e-5;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    const double slope_N =
        (at(place + kStep_mm * axis).energy_N_mm - at(place - kStep_mm * axis).energy_N_mm) / (2.0 * kStep_mm);
    CHECK(glm::dot(at(place).force_N, axis) == doctest::Approx(-slope_N).epsilon(1e-6));
  }
}
