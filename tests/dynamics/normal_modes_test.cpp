// Modes and compliances of elastic networks, against closed forms, a dense eigensolver, and the literature.
#include "engine/dynamics/normal_modes.h"

#include <cmath>

#include "engine/structure/superposition.h"
#include "tests/dynamics/networks.h"

using namespace moltact;
using namespace moltact::test;

namespace {

NormalModes modesOf(const ElasticNetwork& network, std::size_t count) {
  auto out = lowestModes(network, count);
  if (!out) FAIL(out.problem().text());
  return *std::move(out);
}

}  // namespace

TEST_CASE("the modes of a regular tetrahedron are 1 (twice), 2 (three times) and 4 times the spring") {
  const Molecule four = beads({{5, 5, 5}, {5, -5, -5}, {-5, 5, -5}, {-5, -5, 5}});
  const NormalModes modes = modesOf(networkOf(four), 10);
  REQUIRE(modes.count() == 6);
  const double expected[] = {1, 1, 2, 2, 2, 4};
  for (std::size_t k = 0; k < 6; ++k) CHECK(modes.eigenvalues[k] == doctest::Approx(expected[k]).epsilon(1e-9));
  // The breathing mode moves every node along its radius.
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 radius = glm::normalize(four.spheres[i].centre_A);
    CHECK(std::abs(glm::dot(modes.mode(5)[i], radius)) == doctest::Approx(0.5).epsilon(1e-9));
  }
}

TEST_CASE("the 20 lowest modes of ubiquitin are those of a dense eigensolver within 1e-9") {
  const Molecule molecule = libraryMolecule("1ubq.pdb");
  const ElasticNetwork network = networkOf(molecule);
  CHECK(network.nodes().size() == 76);
  CHECK(network.springs().size() == 1416);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense(denseHessian(network));
  CHECK(dense.eigenvalues()[5] < 1e-10);
  const NormalModes modes = modesOf(network, 20);
  REQUIRE(modes.count() == 20);
  for (std::size_t k = 0; k < 20; ++k) {
    CHECK(modes.eigenvalues[k] == doctest::Approx(dense.eigenvalues()[Eigen::Index(k) + 6]).epsilon(1e-9));
    double along = 0.0, length2 = 0.0;
    for (std::size_t i = 0; i < modes.nodes; ++i)
      for (int c = 0; c < 3; ++c) {
        const double v = modes.mode(k)[i][c];
        along += v * dense.eigenvectors()(Eigen::Index(3 * i) + c, Eigen::Index(k) + 6);
        length2 += v * v;
      }
    CHECK(length2 == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(std::abs(along) == doctest::Approx(1.0).epsilon(1e-7));
  }
}

TEST_CASE("a node's compliance is its block of the pseudo-inverse, within 1e-6") {
  const ElasticNetwork network = networkOf(libraryMolecule("1ubq.pdb"));
  const Eigen::MatrixXd inverse = pseudoInverse(denseHessian(network));
  const std::vector<glm::dmat3> got = nodeCompliances(network);
  REQUIRE(got.size() == 76);
  for (std::size_t i = 0; i < got.size(); ++i) {
    const Eigen::Matrix3d block = inverse.block(Eigen::Index(3 * i), Eigen::Index(3 * i), 3, 3);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) CHECK(std::abs(got[i][c][r] - block(r, c)) < 1e-6 * block.trace());
    CHECK(fluctuation(got[i]) == doctest::Approx(block.trace()).epsilon(1e-6));
    CHECK(greatestCompliance(got[i]) == doctest::Approx(block.operatorNorm()).epsilon(1e-6));
  }
  int calls = 0;
  CHECK(nodeCompliances(network, [&](double) { return ++calls < 10; }).empty());
  CHECK(calls == 10);
}

TEST_CASE("adenylate kinase: the first mode of the open form has an overlap of 0.80 with the closing, ten have 0.97") {
  const Molecule open = libraryMolecule("4ake.pdb"), closed = libraryMolecule("1ake.pdb");
  const ElasticNetwork network = networkOf(open);
  REQUIRE(network.nodes().size() == 214);
  CHECK(network.springs().size() == 4515);
  const auto both = twoStates(open, closed);
  REQUIRE(both);
  CHECK(both->fit.rmsd_A == doctest::Approx(7.13).epsilon(0.01));
  std::vector<Vec3> change;
  for (const std::uint32_t atom : network.nodes())
    change.push_back(both->second[atom].centre_A - both->first[atom].centre_A);
  const NormalModes modes = modesOf(network, 20);
  const std::vector<double> overlaps = modeOverlaps(modes, change);
  double squares = 0.0;
  for (std::size_t k = 0; k < 10; ++k) squares += overlaps[k] * overlaps[k];
  CHECK(overlaps[0] == doctest::Approx(0.80).epsilon(0.01));
  CHECK(std::sqrt(squares) == doctest::Approx(0.97).epsilon(0.01));
  // Springs of 0.235 kcal/mol/A^2 reproduce the mean displacement factor; fluctuations correlate with it by 0.81.
  const std::vector<glm::dmat3> compliances = nodeCompliances(network);
  CHECK(springFromDisplacementFactors(network, open, compliances) == doctest::Approx(0.235).epsilon(0.01));
  CHECK(correlationWithDisplacementFactors(network, open, compliances) == doctest::Approx(0.81).epsilon(0.01));
}

TEST_CASE("a network that cannot be made has a problem with a remedy") {
  const auto problem = [](const Molecule& molecule, double cut_off_A) {
    const auto made = ElasticNetwork::make(molecule, cut_off_A);
    REQUIRE_FALSE(made);
    CHECK_FALSE(made.problem().remedy.empty());
    return made.problem().message;
  };
  CHECK(problem(libraryMolecule("water.pdb"), 15.0).find("too few residues") != std::string::npos);
  CHECK(problem(libraryMolecule("1ubq.pdb"), 2.0).find("springs cannot be 2") != std::string::npos);
  CHECK(problem(libraryMolecule("1ubq.pdb"), NAN).find("springs cannot be") != std::string::npos);
  CHECK(problem(beads({{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}, {50, 0, 0}}), 15.0).find("in 2 parts") !=
        std::string::npos);
  // Four nodes on a line bend without stretching a spring.
  const auto modes = lowestModes(networkOf(beads({{0, 0, 0}, {5, 0, 0}, {10, 0, 0}, {15, 0, 0}})), 6);
  REQUIRE_FALSE(modes);
  CHECK(modes.problem().message.find("without stretching") != std::string::npos);
}

TEST_CASE("atoms that are left out have no node, and do not change the network of the others") {
  const Molecule both = libraryMolecule("1hpv.pdb");
  std::vector<std::uint32_t> ligand;
  for (const Residue& r : both.residues)
    if (r.kind == ResidueKind::Ligand)
      for (std::uint32_t i = 0; i < r.atom_count; ++i) ligand.push_back(r.first_atom + i);
  REQUIRE(ligand.size() == 35);
  const auto with = ElasticNetwork::make(both), without = ElasticNetwork::make(both, 15.0, ligand);
  REQUIRE(with);
  REQUIRE(without);
  CHECK(with->nodes().size() == 199);
  CHECK(without->nodes().size() == 198);
  for (const std::uint32_t i : ligand) CHECK(without->nodeOf(i) == ElasticNetwork::kNoNode);
  CHECK(with->nodeOf(ligand[0]) < 199);
}
