// Two superposed structures, against a known rotation and an independent computation of the fit.
#include "engine/structure/superposition.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "engine/haptics/sphere_motion.h"
#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

/// The least RMSD of two lists of places by Horn's quaternions: the largest eigenvalue of a 4 by 4 matrix, here by
/// repeated multiplication.
double leastRmsd_A(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Vec3 ca(0.0), cb(0.0);
  for (std::size_t i = 0; i < a.size(); ++i) ca += a[i] / double(a.size()), cb += b[i] / double(a.size());
  double s[3][3] = {}, squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 p = b[i] - cb, q = a[i] - ca;
    squares += glm::dot(p, p) + glm::dot(q, q);
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y) s[x][y] += p[x] * q[y];
  }
  const double n[4][4] = {{s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
                          {s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
                          {s[2][0] - s[0][2], s[0][1] + s[1][0], -s[0][0] + s[1][1] - s[2][2], s[1][2] + s[2][1]},
                          {s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], -s[0][0] - s[1][1] + s[2][2]}};
  double v[4] = {0.5, 0.4, 0.6, 0.48}, largest = 0.0;
  for (int k = 0; k < 20'000; ++k) {
    double w[4] = {}, length = 0.0;
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 4; ++y) w[x] += n[x][y] * v[y];
      w[x] += squares * v[x];  // makes the largest eigenvalue the largest in size
      length += w[x] * w[x];
    }
    length = std::sqrt(length);
    for (int x = 0; x < 4; ++x) v[x] = w[x] / length;
    largest = length - squares;
  }
  return std::sqrt(std::max(0.0, (squares - 2.0 * largest) / double(a.size())));
}

template <class By>
Molecule moved(const Molecule& m, By&& by) {
  std::vector<Sphere> spheres = m.spheres.copy();
  for (Sphere& b : spheres) b.centre_A = by(b.centre_A);
  return m.movedTo(std::move(spheres));
}

Superposition someTurn() {
  return {glm::dmat3(glm::rotate(glm::dmat4(1.0), 2.1, glm::normalize(Vec3(1, 2, -3)))), Vec3(30, -12, 7)};
}

}  // namespace

TEST_CASE("a protein that was turned by 2.1 rad and shifted by 33 A comes back, to 1e-6 A") {
  const Molecule m = libraryMolecule("1ubq.pdb"), other = moved(m, someTurn());
  const auto pairs = matchAtoms(m, other);
  CHECK(pairs.size() == m.atoms.size());
  const auto fit = superpose(m, other, pairs);
  REQUIRE(fit);
  CHECK(fit->fitted == 76);
  CHECK(fit->rmsd_A < 1e-4);
  for (std::size_t i = 0; i < m.atoms.size(); ++i)
    CHECK(glm::distance((*fit)(other.spheres[i].centre_A), m.spheres[i].centre_A) < 1e-6);
  std::vector<Vec3> places_A;
  for (const Sphere& s : other.spheres) places_A.push_back(s.centre_A);
  const auto of_places = superpose(m, places_A, pairs);
  REQUIRE(of_places);
  CHECK(of_places->rotation == fit->rotation);
  CHECK(of_places->shift_A == fit->shift_A);
  CHECK(of_places->fitted == 76);
}

TEST_CASE(
    "the RMSD of noisy states and of haemoglobin's alpha and beta chains is the least, as Horn's quaternions have it") {
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0.0, 0.8);
  const Molecule m = libraryMolecule("1ubq.pdb");
  const Molecule noisy = moved(moved(m, someTurn()), [&](const Vec3& p) {
    const double x = noise(random), y = noise(random);
    return p + Vec3(x, y, noise(random));
  });
  Molecule alpha = libraryMolecule("2hhb.pdb"), beta = alpha;
  const auto keepChain = [](Molecule& whole, const char* chain) {
    std::string text;
    std::istringstream lines(libraryText("2hhb.pdb"));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("ATOM") && line.substr(21, 1) == chain) text += line + "\n";
    whole = moleculeOf(text + "END\n");
  };
  keepChain(alpha, "A");
  keepChain(beta, "B");
  using Two = std::pair<const Molecule*, const Molecule*>;
  for (const auto& [one, other] : {Two{&m, &noisy}, Two{&alpha, &beta}}) {
    const auto pairs = matchAtoms(*one, *other);
    const auto fit = superpose(*one, *other, pairs);
    REQUIRE(fit);
    std::vector<Vec3> here, there;
    double squares = 0.0;
    for (const auto& [i, j] : pairs) {
      if (one->atoms[i].nameText() != "CA") continue;
      here.push_back(one->spheres[i].centre_A);
      there.push_back(other->spheres[j].centre_A);
      const Vec3 apart = (*fit)(there.back()) - here.back();
      squares += glm::dot(apart, apart);
    }
    CHECK(fit->fitted == here.size());
    CHECK(fit->rmsd_A == doctest::Approx(leastRmsd_A(here, there)).epsilon(1e-6));
    CHECK(fit->rmsd_A == doctest::Approx(std::sqrt(squares / double(here.size()))).epsilon(1e-6));
    CHECK(glm::determinant(fit->rotation) == doctest::Approx(1.0));
  }
}

TEST_CASE("between two states each sphere goes straight; an atom that the other lacks goes with its residue") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  std::string text;
  std::istringstream lines(libraryText("1ubq.pdb"));
  for (std::string line; std::getline(lines, line);)  // without NZ of Lys 48 and the whole of Gly 76
    if (line.starts_with("ATOM") && !(line.substr(22, 4) == "  48" && line.substr(12, 4) == " NZ ") &&
        line.substr(22, 4) != "  76")
      text += line + "\n";
  Molecule other = moleculeOf(text + "END\n");
  std::vector<Sphere> shifted = other.spheres.copy();
  for (std::size_t i = 0; i < shifted.size(); ++i)
    if (other.residues[other.atoms[i].residue].number == 48) shifted[i].centre_A += Vec3(0, 3, 0);
  other.spheres = std::move(shifted);
  other = moved(other, someTurn());
  const auto states = twoStates(m, other);
  REQUIRE(states);
  CHECK(states->matched == m.atoms.size() - 6);
  const auto way = [&](std::size_t i) { return states->second[i].centre_A - states->first[i].centre_A; };
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    const int number = m.residues[m.atoms[i].residue].number;
    if (number == 48 && ++looked_at) CHECK(glm::length(way(i) - Vec3(0, 3, 0)) < 0.2);
    if (number == 76 && ++looked_at) CHECK(way(i) == Vec3(0.0));
  }
  CHECK(looked_at == 14);
  const auto half = states->at(0.5);
  for (std::size_t i = 0; i < half.size(); ++i) {
    CHECK(glm::length(half[i].centre_A - states->first[i].centre_A - 0.5 * way(i)) < 1e-12);
    CHECK(half[i].radius_A == states->first[i].radius_A);
  }
  const auto motion = SphereMotion::make(states->at(0.0), states->at(1.0), 100);
  REQUIRE(motion);
  CHECK(glm::distance((**motion).at(0.5)[3].centre_A, half[3].centre_A) < 1e-12);
}

TEST_CASE("what cannot be superposed is reported: nothing in common, atoms on a line") {
  const Molecule m = libraryMolecule("1ubq.pdb");
  const auto other = twoStates(m, libraryMolecule("argon.pdb"));
  REQUIRE_FALSE(other);
  CHECK(other.problem().text() ==
        "only 0 atoms are in both structures; take two structures of one molecule, with the same chains and residue "
        "numbers");
  std::string line;
  for (int i = 0; i < 5; ++i) {
    char out[96];
    std::snprintf(out, sizeof out, "HETATM%5d  C%d  LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00           C  \n", i, i,
                  1.5 * i, 3.0 * i, 0.0);
    line += out;
  }
  const Molecule straight = moleculeOf(line + "END\n");
  const auto along = twoStates(straight, straight);
  REQUIRE_FALSE(along);
  CHECK(along.problem().message == "the atoms that are in both structures lie on a line");
}
