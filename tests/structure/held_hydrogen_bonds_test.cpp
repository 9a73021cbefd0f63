// Hydrogen bonds of a held body. Oracle: findHydrogenBonds on the molecule with the body's atoms at their new places.
#include <algorithm>
#include <random>

#include "engine/structure/hydrogen_bonds.h"
#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

struct Drug {
  Molecule molecule = libraryMolecule("1hpv.pdb");
  std::shared_ptr<const HeldBody> body;
  std::shared_ptr<const SphereGrid> spheres;

  Drug() {
    std::vector<std::uint32_t> atoms;
    for (const Residue& r : molecule.residues)
      if (r.kind == ResidueKind::Ligand)
        for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) atoms.push_back(i);
    REQUIRE_FALSE(atoms.empty());
    body = heldBody(molecule.spheres, atoms);
    spheres = std::make_shared<const SphereGrid>(molecule.spheres, atoms);
  }
  std::vector<HydrogenBond> across(const Molecule& placed) const {
    const auto held = [&](std::uint32_t i) { return std::binary_search(body->atoms.begin(), body->atoms.end(), i); };
    std::vector<HydrogenBond> out;
    for (const HydrogenBond& b : findHydrogenBonds(placed, BondTable(placed.atoms.size(), findBonds(molecule))))
      if (held(b.donor) != held(b.acceptor)) out.push_back(b);
    return out;
  }
};

}  // namespace

TEST_CASE(
    "amprenavir at its place in 1HPV has the hydrogen bonds of the file with the protease, and in 60 poses near it "
    "those "
    "of a molecule with its atoms moved there; 60 A away it has none") {
  const Drug drug;
  const HeldHydrogenBonds bonds(drug.molecule, *drug.spheres, *drug.body);
  const auto same = [](const std::vector<HydrogenBond>& a, const std::vector<HydrogenBond>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      CHECK(a[k].donor == b[k].donor);
      CHECK(a[k].acceptor == b[k].acceptor);
      CHECK(a[k].length_A == doctest::Approx(b[k].length_A).epsilon(1e-9));
    }
  };
  const std::vector<HydrogenBond> at_rest = bonds.at({drug.body->middle});
  CHECK(at_rest.size() >= 4);
  same(at_rest, drug.across(drug.molecule));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.8, 0.8), turn(-0.3, 0.3);
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    const PoseA pose{{drug.body->middle.A + Vec3(shift(random), shift(random), shift(random))},
                     glm::normalize(Quat(1.0, turn(random), turn(random), turn(random)))};
    std::vector<Sphere> placed(drug.molecule.spheres.begin(), drug.molecule.spheres.end());
    for (std::size_t k = 0; k < drug.body->atoms.size(); ++k)
      placed[drug.body->atoms[k]].centre_A = pose.place.A + pose.orientation * drug.body->spheres[k].centre_A;
    const std::vector<HydrogenBond> here = bonds.at(pose);
    same(here, drug.across(drug.molecule.movedTo(std::move(placed))));
    found += here.size();
  }
  CHECK(found > 60);
  CHECK(bonds.at({{drug.body->middle.A + Vec3(60.0, 0.0, 0.0)}}).empty());
}
