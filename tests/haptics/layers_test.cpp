// Layers on top of an interaction: friction and a field of charges, on the probe and on a body. Closed forms on a wall,
// a sphere of radius 1e5 A, and between point charges.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/interactions.h"
#include "tests/haptics/body_paths.h"
#include "tests/haptics/fields.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

constexpr double kCoefficient = 0.4, kCoulomb_N_A2 = 2.0;

// Coulomb's law between the charges of the scene and unit charges: one at a probe, or one on each atom of a body.
struct CoulombPair {
  double charge_e;
  test::PairEnergy at(double r) const {
    const double e = kCoulomb_N_A2 * charge_e / r;
    return {e, -e / r, 2.0 * e / (r * r)};
  }
};

std::unique_ptr<Interaction> charged(std::unique_ptr<Interaction> inner, const InteractionInput& input) {
  using Field = test::InField<CoulombPair>;
  auto out = std::make_unique<Field>(std::move(inner), CoulombPair{input.chemistry->charges_e[0]},
                                     std::vector<Field::Atom>{{0, (*input.spheres)[0].centre_A}});
  if (input.body) {
    out->sites_A.clear();
    for (const Sphere& s : input.body->spheres) out->sites_A.push_back(s.centre_A);
  }
  return out;
}

bool withCharges(const TouchSetup& touch) { return touch.charges != kNoCharges; }

const std::array kCharged{InteractionLayer{"coulomb", &withCharges, &charged, true}};

// Every way to feel a scene, a probe or a body of two atoms 4 A apart, both of radius 1.
std::vector<InteractionInput> allInputs(const std::shared_ptr<const SphereGrid>& scene) {
  std::vector<InteractionInput> out;
  for (const InteractionKind& kind : interactionKinds()) {
    InteractionInput input{.spheres = scene};
    input.touch.interaction = kind.name;
    input.touch.probe_A = 1.0;
    if (kind.holds_body) input.body = bodyOfSpheres({{{-2, 0, 0}, 1.0}, {{2, 0, 0}, 1.0}});
    out.push_back(std::move(input));
  }
  return out;
}

}  // namespace

TEST_CASE(
    "with a coefficient of friction of 0 the exact body has the poses, forces and torques of the body itself, to the "
    "last bit") {
  const std::vector<Sphere> atoms = scenes::cluster(20, 5).spheres;
  const auto scene = test::makeScene(atoms);
  const auto body = bodyOfSpheres({{{-2, 0, 0}, 1.0}, {{2, 0, 0}, 1.2}, {{0, 1, 1}, 0.8}});
  InteractionInput input{.spheres = scene, .body = body};
  input.touch.interaction = "exact-body";
  const auto felt = makeInteraction(input);
  ExactBody bare(scene, body);
  int touching = 0, different = 0;
  for (const PoseA& pose : test::bodyPath(atoms, body->reach_A, 2000, 5, 0.02, 0.01, 0.5)) {
    const Response a = felt->respond(pose), b = bare.respond(pose);
    touching += a.contact.touching();
    different +=
        !(a.contact == b.contact && a.torque_A2 == b.torque_A2 && a.body_pose.has_value() == b.body_pose.has_value());
    if (a.body_pose && b.body_pose)
      different += a.body_pose->place.A != b.body_pose->place.A || a.body_pose->orientation != b.body_pose->orientation;
  }
  CHECK(touching > 100);
  CHECK(different == 0);
}

TEST_CASE(
    "friction of 0.4 as a layer drags the probe, the exact body and the springs of a body along a wall by 0.4 of what "
    "they press with, and ten ways to and fro take the work of the drag from the hand") {
  constexpr double kWall_A = 1e5;
  const auto wall = test::makeScene({{{0, 0, -kWall_A}, kWall_A}});
  for (InteractionInput input : allInputs(wall)) {
    CAPTURE(input.touch.interaction);
    const auto smooth = makeInteraction(input);
    input.touch.friction = kCoefficient;
    const auto felt = makeInteraction(input);
    REQUIRE(felt);
    Vec3 at(0, 0, 3), force(0.0);
    double worked_A2 = 0.0;  // by the hand, for a spring of 1 N/A
    Response last, bare;
    const auto go = [&](const Vec3& to) {
      const Vec3 from = at;
      for (int k = 1; k <= 400; ++k) {
        const Vec3 next = from + (to - from) * (k / 400.0);
        last = felt->respond({{next}, kNoRotation});
        bare = smooth->respond({{next}, kNoRotation});
        worked_A2 -= 0.5 * glm::dot(force + last.contact.displacement_A, next - at);
        at = next;
        force = last.contact.displacement_A;
      }
    };
    go({0, 0, 0.5});  // 0.5 A deep
    go({4, 0, 0.5});
    const double pressed_A = last.contact.displacement_A.z;
    CHECK(pressed_A == doctest::Approx(bare.contact.displacement_A.z).epsilon(1e-4));
    CHECK(pressed_A > 0.49);
    CHECK(std::abs(bare.contact.displacement_A.x) < 1e-4);
    CHECK(last.contact.displacement_A.x == doctest::Approx(-kCoefficient * pressed_A).epsilon(1e-3));
    worked_A2 = 0.0;
    for (int k = 0; k < 10; ++k) {
      go({-4, 0, 0.5});
      go({4, 0, 0.5});
    }
    // A parallelogram of force against way: 2 drags high, 8 A less the 2 drags that the spring stretches wide.
    const double drag_A = kCoefficient * pressed_A;
    CHECK(worked_A2 == doctest::Approx(10 * 2.0 * drag_A * (8.0 - 2.0 * drag_A)).epsilon(0.01));
  }
}

TEST_CASE(
    "a field of charges as a layer gets the chemistry where it acts and pushes probe and body by Coulomb's law, beside "
    "or without a contact") {
  const auto scene = test::makeScene({{{0, 0, 0}, 1.5}});
  for (InteractionInput input : allInputs(scene)) {
    CAPTURE(input.touch.interaction);
    CHECK_FALSE(needsChemistry(input.touch, kCharged));
    CHECK_FALSE(makeInteraction(input, kCharged)->respond({{Vec3(0, 0, 9)}, kNoRotation}).field);
    input.touch.charges = kFileCharges;
    CHECK(needsChemistry(input.touch, kCharged));
    CHECK_FALSE(needsChemistry(input.touch));
    CHECK_FALSE(makeInteraction(input, kCharged));  // no chemistry
    input.chemistry = std::make_shared<const AtomChemistry>(AtomChemistry{{8}, {0}, {0.5F}, {"O"}});
    const auto felt = makeInteraction(input, kCharged);
    // Turned by a quarter about z, so that the body's atoms are at y = 2 and y = -2.
    const Quat turned = glm::angleAxis(0.5 * std::numbers::pi, Vec3(0, 0, 1));
    const Vec3 place(3, 1, 6);
    Vec3 force_N(0.0), torque_N_A(0.0);
    double energy_N_A = 0.0;
    for (const Vec3& site : input.body ? std::vector<Vec3>{{0, -2, 0}, {0, 2, 0}} : std::vector<Vec3>{Vec3(0.0)}) {
      const Vec3 from = place + site;
      const double r = glm::length(from);
      force_N += kCoulomb_N_A2 * 0.5 * from / (r * r * r);
      torque_N_A += glm::cross(site, kCoulomb_N_A2 * 0.5 * from / (r * r * r));
      energy_N_A += kCoulomb_N_A2 * 0.5 / r;
    }
    const Response free = felt->respond({{place}, turned});
    REQUIRE(free.field);
    CHECK_FALSE(free.contact.touching());
    CHECK(glm::distance(free.field->force_N, force_N) < 1e-12);
    CHECK(glm::distance(free.field->torque_N_A, torque_N_A) < 1e-12);
    CHECK(free.field->energy_N_A == doctest::Approx(energy_N_A).epsilon(1e-12));
    // In contact the reactions on the atom are the opposite of contact and field together.
    Response touched;
    for (int k = 0; k <= 100; ++k) touched = felt->respond({{Vec3(0, 0, 6.0 - 0.05 * k)}, kNoRotation});
    if (!input.body) CHECK(touched.contact.touching());
    std::vector<AtomForce> room(felt->maxReactionCount());
    Vec3 sum(0.0);
    const std::size_t count = felt->reactions(touched, 2.0, 1.0, room);
    for (std::size_t k = 0; k < count; ++k) sum += room[k].force_N;
    CHECK(glm::distance(sum, -touched.total(2.0).force_N) < 1e-9);
  }
}
