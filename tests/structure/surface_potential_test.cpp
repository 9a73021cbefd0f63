// The potential on the surface. Oracle: Coulomb's law for one and two charges.
#include "engine/structure/surface_potential.h"

#include <cmath>

#include "engine/molecule/reader.h"
#include "engine/structure/colouring.h"
#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// Atoms without residues, with charges of their own.
Molecule charged(const std::vector<std::pair<Vec3, float>>& atoms) {
  Molecule m;
  std::vector<PlacedAtom> placed;
  std::vector<float> charges;
  for (const auto& [at, charge] : atoms) {
    PlacedAtom atom;
    atom.atomic_number = 6;
    atom.position = {at};
    atom.radius_A = 1.7;
    placed.push_back(atom);
    charges.push_back(charge);
  }
  m.setAtoms(placed);
  m.charges_e = std::move(charges);
  return m;
}

}  // namespace

TEST_CASE(
    "on the sphere of 3.1 A about one charge of 0.5 e the potential is 332.06 * 0.5 / 3.1 in vacuum and a 4 * 3.1th of "
    "that with a dielectric of four times the distance; a charge inside others has none") {
  const Molecule one = charged({{Vec3(0.0), 0.5f}});
  const double vacuum = 332.0637 * 0.5 / 3.1;
  CHECK(surfacePotential_kcal_mol_e(one, dielectricChoice("vacuum"))[0] == doctest::Approx(vacuum).epsilon(1e-4));
  CHECK(surfacePotential_kcal_mol_e(one, dielectricChoice("distance"))[0] ==
        doctest::Approx(vacuum / (4.0 * 3.1)).epsilon(1e-4));
  const double water = surfacePotential_kcal_mol_e(one, dielectricChoice("water"))[0];
  CHECK(water > 0.0);
  CHECK(water < vacuum);
  // Six neighbours at 1.5 A cover the middle one.
  std::vector<std::pair<Vec3, float>> cage{{Vec3(0.0), 1.0f}};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.5, 1.5}) {
      Vec3 at(0.0);
      at[axis] = side;
      cage.push_back({at, 0.0f});
    }
  const std::vector<float> covered = surfacePotential_kcal_mol_e(charged(cage), dielectricChoice("vacuum"));
  CHECK(std::isnan(covered[0]));
  for (std::size_t k = 1; k < covered.size(); ++k) CHECK(covered[k] > 0.0f);
}

TEST_CASE("what the hand holds and the rest neither cover nor charge each other") {
  const Molecule two = charged({{Vec3(0.0), 1.0f}, {Vec3(1.0, 0.0, 0.0), -1.0f}});
  const double alone = 332.0637 / (4.0 * 3.1 * 3.1);
  const std::vector<std::uint32_t> held{1};
  const std::vector<float> apart = surfacePotential_kcal_mol_e(two, dielectricChoice("distance"), held);
  CHECK(apart[0] == doctest::Approx(alone).epsilon(1e-4));
  CHECK(apart[1] == doctest::Approx(-alone).epsilon(1e-4));
  const std::vector<float> together = surfacePotential_kcal_mol_e(two, dielectricChoice("distance"));
  CHECK(std::abs(together[0]) < 0.7 * alone);
  CHECK(together[0] == doctest::Approx(-together[1]).epsilon(0.05));
}

TEST_CASE(
    "the scale ends at 1, 2 or 5 times a power of ten; a negative charge is red, a positive one blue, and a molecule "
    "without charges grey") {
  const std::vector<float> small{0.03f, -0.041f, NAN}, none{0.0f, NAN}, large(100, 17.0f);
  CHECK(potentialRange_kcal_mol_e(small) == doctest::Approx(0.05));
  CHECK(potentialRange_kcal_mol_e(large) == doctest::Approx(20.0));
  CHECK(potentialRange_kcal_mol_e(none) == 0.0);
  const ColouringScheme& scheme = **findColouringScheme("potential");
  const Colouring two =
      colourMolecule(charged({{Vec3(0.0), 1.0f}, {Vec3(40.0, 0.0, 0.0), -1.0f}}), scheme, {.dielectric = "distance"});
  CHECK(two.of_atom[0][2] > two.of_atom[0][0] + 40);
  CHECK(two.of_atom[1][0] > two.of_atom[1][2] + 40);
  REQUIRE(two.legend.gradient);
  REQUIRE(two.legend.entries.size() == 5);
  CHECK(two.legend.entries.front().name == "-10 kcal/mol/e");
  CHECK(two.legend.entries.back().name == "10 kcal/mol/e");
  const Molecule grey = charged({{Vec3(0.0), 0.0f}});
  CHECK_FALSE(colourMolecule(grey, scheme).legend.gradient);
}
