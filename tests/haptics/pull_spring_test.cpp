// The spring by which the hand holds atoms: its force in closed form, the motion of the atoms, and the energy round a
// closed path.
#include "engine/haptics/pull_spring.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/haptics/interactions.h"

using namespace moltact;

namespace {

const std::vector<Sphere> kThree{{{0, 0, 0}, 1.5}, {{4, 0, 0}, 1.5}, {{0, 9, 0}, 1.5}};

std::unique_ptr<PullSpring> springTo(std::vector<std::uint32_t> atoms, const std::vector<double>& masses = {}) {
  InteractionInput input;
  input.spheres = std::make_shared<const SphereGrid>(kThree);
  return std::make_unique<PullSpring>(makeInteraction(input), std::move(atoms), kThree, masses);
}

PoseA at(const Vec3& place) { return {{place}}; }

}  // namespace

TEST_CASE("a hand that has moved by d from where it took hold feels -d, on any atom: the contact plays no part") {
  const auto spring = springTo({0, 1});
  CHECK(spring->respond(at({1, 1, 1})).contact.displacement_A == Vec3(0.0));
  const Response moved = spring->respond(at({1.5, -1, 1.25}));  // inside the first sphere
  CHECK(glm::distance(moved.contact.displacement_A, Vec3(-0.5, 2, -0.25)) < 1e-12);
  CHECK(moved.contact.energy_A2 == doctest::Approx(0.5 * (0.25 + 4 + 0.0625)));
  CHECK_FALSE(moved.contact.touching());
  CHECK(moved.acts());
  // The reactions are shared equally and sum up to the opposite of the force.
  std::array<AtomForce, 2> reactions;
  REQUIRE(spring->maxReactionCount() == 2);
  REQUIRE(spring->reactions(moved, 3.0, 1.0, reactions) == 2);
  CHECK(reactions[0].atom == 0);
  CHECK(reactions[1].atom == 1);
  CHECK(glm::distance(reactions[0].force_N, Vec3(0.75, -3, 0.375)) < 1e-12);
  CHECK(glm::distance(reactions[0].force_N + reactions[1].force_N, -moved.total(3.0).force_N) < 1e-12);
  // A new start begins without force.
  spring->reset();
  CHECK(spring->respond(at({1.5, -1, 1.25})).contact.displacement_A == Vec3(0.0));
}

TEST_CASE(
    "the atoms' motion pulls the hand: their centre moved by (1, 0, 0) gives (0.25, 0, 0) at a quarter of the way") {
  const auto spring = springTo({0, 2});
  spring->respond(at({0, 5, 0}));
  std::vector<Sphere> to = kThree;
  to[0].centre_A.x += 2.0;  // the centre of the two moves by 1
  to[1].centre_A.y += 7.0;  // is not held
  const auto motion = SphereMotion::make(kThree, to, 20);
  REQUIRE(motion);
  CHECK(spring->setMotion(motion->get()));
  CHECK(spring->respond(at({0, 5, 0})).contact.displacement_A == Vec3(0.0));
  spring->advanceTo(0.25);
  CHECK(glm::distance(spring->respond(at({0, 5, 0})).contact.displacement_A, Vec3(0.25, 0, 0)) < 1e-12);
  spring->advanceTo(1.0);
  CHECK(glm::distance(spring->respond(at({0, 5, 0})).contact.displacement_A, Vec3(1, 0, 0)) < 1e-12);
  spring->setMotion(nullptr);
  CHECK(spring->respond(at({0, 5, 0})).contact.displacement_A == Vec3(0.0));
}

TEST_CASE(
    "the spring holds the centre of mass: of 12 u and 4 u, the motion of the light one by 1 A pulls by 0.25 A, and the "
    "reactions are shared 3 to 1") {
  const auto spring = springTo({0, 1}, {12.0, 4.0});
  spring->respond(at({0, 5, 0}));
  std::vector<Sphere> to = kThree;
  to[1].centre_A.z += 1.0;
  const auto motion = SphereMotion::make(kThree, to, 20);
  REQUIRE(motion);
  spring->setMotion(motion->get());
  spring->advanceTo(1.0);
  const Response now = spring->respond(at({0, 5, 0}));
  CHECK(glm::distance(now.contact.displacement_A, Vec3(0, 0, 0.25)) < 1e-12);
  std::array<AtomForce, 2> reactions;
  REQUIRE(spring->reactions(now, 2.0, 1.0, reactions) == 2);
  CHECK(glm::distance(reactions[0].force_N, Vec3(0, 0, -0.375)) < 1e-12);
  CHECK(glm::distance(reactions[1].force_N, Vec3(0, 0, -0.125)) < 1e-12);
  CHECK(PullSpring::sharesOf(std::vector{0.0, 0.0}, 2) == std::vector{0.5, 0.5});
}

TEST_CASE(
    "round a closed path of 10 000 random poses the hand gains no energy: each step's work is the energy's change") {
  constexpr unsigned kSeed = 7;
  MESSAGE("seed ", kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> in(-6.0, 6.0);
  const auto spring = springTo({1});
  Response last = spring->respond(at({0, 0, 0}));
  Vec3 place(0.0);
  double worst = 0.0;
  for (int k = 0; k < 10000; ++k) {
    const Vec3 next = k == 9999 ? Vec3(0.0) : Vec3(in(random), in(random), in(random));
    const Response now = spring->respond(at(next));
    // A linear force does the work of its mean.
    const double work = glm::dot(0.5 * (last.contact.displacement_A + now.contact.displacement_A), next - place);
    worst = std::max(worst, std::abs(work + now.contact.energy_A2 - last.contact.energy_A2));
    last = now;
    place = next;
  }
  CHECK(worst < 1e-10);
  CHECK(last.contact.energy_A2 == 0.0);
  const Response lost = spring->respond(at(Vec3(std::numeric_limits<double>::quiet_NaN())));
  CHECK(lost.contact.fault == Fault::NotFinite);
  CHECK(lost.contact.displacement_A == Vec3(0.0));
}
