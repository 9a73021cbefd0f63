// Two molecules beside each other: the second one's place, orientation and chain names.
#include "engine/molecule/side_by_side.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "engine/molecule/reader.h"
#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

Molecule sideBySideLibrary(const std::string& file, const ReadOptions& options = {}) {
  auto molecule = readMolecule(libraryFolder() / file, options);
  REQUIRE_MESSAGE(molecule, file);
  return *std::move(molecule);
}

struct Extent {
  double low = 1e300, high = -1e300;
};
Extent along(const Molecule& m, std::size_t from, std::size_t to, int axis) {
  Extent e;
  for (std::size_t i = from; i < to; ++i) {
    e.low = std::min(e.low, m.spheres[i].centre_A[axis] - m.spheres[i].radius_A);
    e.high = std::max(e.high, m.spheres[i].centre_A[axis] + m.spheres[i].radius_A);
  }
  return e;
}

}  // namespace

TEST_CASE(
    "beside ubiquitin benzene stands 10 Å to the right of it, in its middle's height and depth; nothing else has "
    "moved") {
  const Molecule alone = sideBySideLibrary("1ubq.pdb"), ring = sideBySideLibrary("benzene.pdb");
  const Molecule both = sideBySideLibrary("1ubq.pdb", {.beside = "benzene"});
  REQUIRE(both.atoms.size() == alone.atoms.size() + ring.atoms.size());
  REQUIRE(both.beside_from == alone.atoms.size());
  CHECK(both.id == alone.id);
  CHECK(both.beside_id == ring.id);
  for (std::size_t i = 0; i < alone.atoms.size(); ++i) CHECK(both.spheres[i].centre_A == alone.spheres[i].centre_A);
  const auto first = [&](int axis) { return along(both, 0, both.beside_from, axis); };
  const auto second = [&](int axis) { return along(both, both.beside_from, both.atoms.size(), axis); };
  CHECK(second(0).low - first(0).high == doctest::Approx(kBesideGap_A));
  for (const int axis : {1, 2})
    CHECK(second(axis).low + second(axis).high == doctest::Approx(first(axis).low + first(axis).high));
  // Its distances within itself are those of its file.
  for (std::size_t i = 1; i < ring.atoms.size(); ++i)
    CHECK(glm::distance(both.spheres[both.beside_from + i].centre_A, both.spheres[both.beside_from].centre_A) ==
          doctest::Approx(glm::distance(ring.spheres[i].centre_A, ring.spheres[0].centre_A)));
}

TEST_CASE("the molecule beside is read as the first is, but for model, assembly and another beside it") {
  CHECK((besideReading({.model = 3, .waters = true, .assembly = "1", .beside = "benzene", .radii = "alvarez"}) ==
         ReadOptions{.waters = true, .radii = "alvarez"}));
  const std::size_t handed_on = 2;  // each option is handed on or is one of the three
  CHECK(readingOptions().size() == handed_on + 3);
}

TEST_CASE("the second's chains have a 2 behind their names, and every atom leads to its own residue and chain") {
  const Molecule both = sideBySideLibrary("1ubq.pdb", {.beside = "1hel"});
  REQUIRE(both.chains.size() == 2);
  CHECK(both.chains[0].name == "A");
  CHECK(both.chains[1].name == "A2");
  for (std::uint32_t i = 0; i < both.atoms.size(); ++i) {
    const Residue& r = both.residues[both.atoms[i].residue];
    CHECK((i >= r.first_atom && i < r.first_atom + r.atom_count));
    CHECK(r.chain == (i >= both.beside_from ? 1 : 0));
  }
  for (const Chain& c : both.chains)
    for (std::uint32_t r = c.first_residue; r < c.first_residue + c.residue_count; ++r)
      CHECK(&both.chains[both.residues[r].chain] == &c);
}

TEST_CASE(
    "the same molecule beside itself, turned at random, stands turned as the first: each atom by the same shift to "
    "1e-6 Å") {
  const Molecule one = sideBySideLibrary("1ubq.pdb");
  Molecule turned = one;
  const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.2)));
  std::vector<Sphere> spheres = one.spheres.copy();
  for (Sphere& b : spheres) b.centre_A = turn * b.centre_A + Vec3(40, -7, 3);
  turned.spheres = std::move(spheres);
  const Molecule both = sideBySide(one, turned);
  const Vec3 shift = both.spheres[both.beside_from].centre_A - both.spheres[0].centre_A;
  CHECK(shift.x > 20.0);
  for (std::size_t i = 0; i < one.atoms.size(); ++i)
    CHECK(glm::distance(both.spheres[both.beside_from + i].centre_A, both.spheres[i].centre_A + shift) < 1e-6);
}

TEST_CASE("what is the same by number alone, and not by name, is not turned") {
  const Molecule one = sideBySideLibrary("1ubq.pdb"), other = sideBySideLibrary("1hel.pdb");
  const Molecule both = sideBySide(one, other);
  const Vec3 shift = both.spheres[both.beside_from].centre_A - other.spheres[0].centre_A;
  for (std::size_t i = 0; i < other.atoms.size(); ++i)
    CHECK(glm::distance(both.spheres[both.beside_from + i].centre_A, other.spheres[i].centre_A + shift) < 1e-9);
}

TEST_CASE(
    "a second molecule that is not there is reported; helices that one file does not record are "
    "found for both") {
  const auto missing = readMolecule(libraryFolder() / "1ubq.pdb", {.beside = "nothing-like-it"});
  REQUIRE(!missing);
  CHECK(!missing.problem().message.empty());
  Molecule one = sideBySideLibrary("1ubq.pdb"), other = sideBySideLibrary("1hel.pdb");
  one.has_recorded_structure = true;
  other.has_recorded_structure = false;
  CHECK(!sideBySide(one, other).has_recorded_structure);
  other.has_recorded_structure = true;
  CHECK(sideBySide(one, other).has_recorded_structure);
}
