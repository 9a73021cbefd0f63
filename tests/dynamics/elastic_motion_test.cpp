// The overdamped motion of elastic networks: static response, energy, restriction to modes, and a hand that pushes
// through a spring with the delay of the servo loop.
#include "engine/dynamics/elastic_motion.h"

#include <cmath>
#include <deque>
#include <random>

#include "tests/dynamics/networks.h"

using namespace moltact;
using namespace moltact::test;

namespace {

struct Elastic {
  std::shared_ptr<const ElasticNetwork> network;
  std::shared_ptr<const NormalModes> modes;

  explicit Elastic(const char* file) {
    network = std::make_shared<const ElasticNetwork>(networkOf(libraryMolecule(file)));
    auto found = lowestModes(*network, 20);
    REQUIRE(found);
    modes = std::make_shared<const NormalModes>(*std::move(found));
  }
  ElasticMotion motion(double spring, double relaxation_s, double step_s = 0.02) const {
    ElasticMotion out(network, modes, spring, step_s);
    out.setRelaxation(relaxation_s);
    return out;
  }
};

double work(std::span<const NodeForce> forces, std::span<const Vec3> before, std::span<const Vec3> after) {
  double out = 0.0;
  for (const NodeForce& f : forces) out += glm::dot(f.force_kcal_mol_A, after[f.node] - before[f.node]);
  return out;
}

}  // namespace

TEST_CASE("under a constant force every node comes to rest at the pseudo-inverse's displacement, within 1e-6 A") {
  const Elastic ubq("1ubq.pdb");
  const Eigen::MatrixXd inverse = pseudoInverse(denseHessian(*ubq.network));
  const double spring = 1.13;
  ElasticMotion motion = ubq.motion(spring, 0.5);
  const std::vector<NodeForce> forces{{7, {0.3, -0.2, 0.5}}, {46, {-0.1, 0.4, 0.0}}, {7, {0.1, 0.0, 0.0}}};
  Eigen::VectorXd f = Eigen::VectorXd::Zero(inverse.rows());
  for (const NodeForce& n : forces)
    for (int c = 0; c < 3; ++c) f[Eigen::Index(3 * n.node) + c] += n.force_kcal_mol_A[c];
  const Eigen::VectorXd expected = inverse * f / spring;
  for (int k = 0; k < 3000; ++k) motion.step(forces);
  for (std::size_t i = 0; i < 76; ++i)
    for (int c = 0; c < 3; ++c)
      CHECK(std::abs(motion.displacements_A()[i][c] - expected[Eigen::Index(3 * i) + c]) < 1e-6);
  CHECK(motion.energy_kcal_mol() == doctest::Approx(0.5 * f.dot(expected)).epsilon(1e-6));
  // Without the force it springs back.
  for (int k = 0; k < 3000; ++k) motion.step({});
  CHECK(motion.maxDisplacement_A() < 1e-6);
}

TEST_CASE("no step gains energy: in 2000 steps under random forces the energy rises by no more than their work") {
  const Elastic ubq("1ubq.pdb");
  const unsigned seed = 20261126;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 2.0);
  std::uniform_int_distribution<std::uint32_t> node(0, 75);
  for (const bool all : {true, false}) {
    ElasticMotion motion = ubq.motion(0.5, 0.1);
    if (!all) motion.restrictTo(std::vector<std::size_t>{0, 3, 4});
    double put_in = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const std::vector<NodeForce> forces{{node(random), {normal(random), normal(random), normal(random)}}};
      const std::vector<Vec3> before(motion.displacements_A().begin(), motion.displacements_A().end());
      const double energy = motion.energy_kcal_mol();
      motion.step(forces);
      const double in = work(forces, before, motion.displacements_A());
      CHECK(motion.energy_kcal_mol() - energy <= in + 1e-9);
      put_in += in;
    }
    CHECK(put_in > 0.0);
  }
}

TEST_CASE(
    "restricted to one mode, a push meets that mode's stiffness; the way back decays by e in the relaxation time") {
  const Elastic ubq("1ubq.pdb");
  const double spring = 1.13, relaxation_s = 0.4, step_s = 1e-3;
  ElasticMotion motion = ubq.motion(spring, relaxation_s, step_s);
  motion.restrictTo({2});
  const Vec3 along = ubq.modes->mode(2)[10];
  const std::vector<NodeForce> forces{{10, {1.0, 0.0, 0.0}}};
  for (int k = 0; k < 10'000; ++k) motion.step(forces);
  const double amplitude = along.x / (spring * ubq.modes->eigenvalues[2]);
  for (std::size_t i = 0; i < 76; ++i)
    CHECK(glm::distance(motion.displacements_A()[i], ubq.modes->mode(2)[i] * amplitude) < 1e-9);
  CHECK(motion.energy_kcal_mol() ==
        doctest::Approx(0.5 * along.x * along.x / (spring * ubq.modes->eigenvalues[2])).epsilon(1e-9));
  const double start = motion.maxDisplacement_A();
  for (int k = 0; k < 400; ++k) motion.step({});
  CHECK(motion.maxDisplacement_A() / start == doctest::Approx(std::exp(-1.0)).epsilon(0.002));
}

TEST_CASE("a molecule at rest in a displaced mode goes there by itself") {
  const Elastic ubq("1ubq.pdb");
  ElasticMotion motion = ubq.motion(1.0, 0.5);
  motion.setRest(std::vector<double>{0.0, 3.0});
  for (int k = 0; k < 3000; ++k) motion.step({});
  for (std::size_t i = 0; i < 76; ++i)
    CHECK(glm::distance(motion.displacements_A()[i], 3.0 * ubq.modes->mode(1)[i]) < 1e-6);
  CHECK(motion.energy_kcal_mol() < 1e-9);
}

TEST_CASE(
    "a hand that pushes through a spring never gets energy back over closed paths, at delays of one to three steps") {
  // The servo loop averages the force over a step and follows each step during the next one; a waiting motion adds one.
  const Elastic adk("4ake.pdb");
  const std::vector<glm::dmat3> compliances = nodeCompliances(*adk.network);
  std::uint32_t softest = 0;
  for (std::uint32_t i = 0; i < compliances.size(); ++i)
    if (fluctuation(compliances[i]) > fluctuation(compliances[softest])) softest = i;
  constexpr double kSpring = 0.235;
  constexpr double kStep_s = 0.02;
  for (const double stiffness : {0.5, 1.5, 5.0, 20.0})  // of the hand's spring, kcal/mol/A^2
    for (const int delay : {1, 2, 3}) {
      INFO("stiffness " << stiffness << ", delay " << delay);
      ElasticMotion motion = adk.motion(
          kSpring, relaxationFor(stiffness, greatestCompliance(compliances[softest]) / kSpring, kStep_s), kStep_s);
      double given = 0.0, farthest = 0.0;
      std::deque<Vec3> late(std::size_t(delay), Vec3(0.0));
      Vec3 hand(0.0), last(0.0), force(0.0);
      for (int turn = 0; turn < 2; ++turn)
        for (int k = 0; k < 300; ++k) {
          const double angle = kTwoPi * k / 300.0;
          hand = Vec3(2.0 * (1.0 - std::cos(angle)), 2.0 * std::sin(angle), std::sin(2.0 * angle));
          given += glm::dot(force, hand - last);
          last = hand;
          force = stiffness * (hand - late.front());
          const std::vector<NodeForce> forces{{softest, force}};
          motion.step(forces);
          late.pop_front();
          late.push_back(motion.displacements_A()[softest]);
          farthest = std::max(farthest, motion.maxDisplacement_A());
        }
      CHECK(given > 0.0);
      CHECK(farthest < 6.0);  // the hand moves by at most 4.4 A: no oscillation grows
      // A hand that stands still lets the molecule come to rest.
      for (int k = 0; k < 1000; ++k) {
        motion.step(std::vector<NodeForce>{{softest, stiffness * (hand - late.front())}});
        late.pop_front();
        late.push_back(motion.displacements_A()[softest]);
      }
      const Vec3 rest = motion.displacements_A()[softest];
      motion.step(std::vector<NodeForce>{{softest, stiffness * (hand - late.front())}});
      CHECK(glm::distance(motion.displacements_A()[softest], rest) < 1e-4);
    }
}
