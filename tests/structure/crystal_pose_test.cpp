// The crystal's pose of amprenavir in HIV protease (1HPV) against the minimum of the forces between atoms.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/field/minimise_pose.h"
#include "engine/molecule/radius_tables.h"
#include "engine/structure/interaction_input.h"
#include "tests/structure/library.h"

using namespace moltact;

namespace {

// Root mean square distance of the body's atoms from their places in the crystal.
double rmsd_A(const HeldBody& body, const Molecule& m, const PoseA& pose) {
  double sum = 0.0;
  for (const std::uint32_t i : body.atoms) {
    const Vec3 home = m.spheres[i].centre_A;
    const Vec3 d = pose.place.A + pose.orientation * (home - body.middle.A) - home;
    sum += glm::dot(d, d);
  }
  return std::sqrt(sum / double(body.atoms.size()));
}

}  // namespace

TEST_CASE(
    "with each table of radii amprenavir in the crystal overlaps its protease by what the table says, within 0.005 A, "
    "and as a held body by nothing") {
  for (const RadiusTable& table : radiusTables()) {
    CAPTURE(std::string(table.word.name));
    const Molecule m = test::libraryMolecule("1hpv.pdb", {.radii = std::string(table.word.name)});
    std::vector<std::uint32_t> ligand;
    for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
      if (m.residues[m.atoms[i].residue].name == "478") ligand.push_back(i);
    const auto body = heldBody(m, ligand);
    REQUIRE(body);
    CHECK(body->overlap_A == table.body_overlap_A);
    double most_A = -1.0, as_body_A = -1.0;
    for (std::size_t k = 0; k < ligand.size(); ++k)
      for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
        if (m.residues[m.atoms[i].residue].name == "478") continue;
        const Sphere &a = m.spheres[ligand[k]], &b = m.spheres[i];
        const double apart_A = glm::distance(a.centre_A, b.centre_A);
        most_A = std::max(most_A, a.radius_A + b.radius_A - apart_A);
        as_body_A = std::max(as_body_A, body->spheres[k].radius_A + b.radius_A - apart_A);
      }
    CHECK(std::abs(most_A - table.ligand_overlap_A) < 0.005);
    CHECK(as_body_A < 0.0);
  }
}

TEST_CASE(
    "amprenavir in 1HPV, minimised from the crystal's pose, stays within 1 A of it in all three dielectrics, and comes "
    "back from each of 40 poses 0.5 A and 15 degrees off, from none to a lower energy") {
  const Molecule m = test::libraryMolecule("1hpv.pdb");
  std::vector<std::uint32_t> ligand;
  for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
    if (m.residues[m.atoms[i].residue].name == "478") ligand.push_back(i);
  REQUIRE(ligand.size() == 35);
  const auto body = heldBody(m.spheres, ligand);
  const auto grid = std::make_shared<const SphereGrid>(std::vector<Sphere>(m.spheres.begin(), m.spheres.end()));
  for (const std::string dielectric : {"water", "distance", "vacuum"}) {
    CAPTURE(dielectric);
    TouchSetup touch;
    touch.forces = "all";
    touch.dielectric = dielectric;
    const auto field = pairField(touch, m, *grid, body.get());
    REQUIRE(field);
    CHECK(field->held.size() == 39);
    PairSum sum(field->places, field->atoms, field->held, field->model);
    const double gyration_A = radiusOfGyration_A(field->held);
    PoseMinimiser minimiser(sum, gyration_A);
    const PoseA crystal{body->middle, kNoRotation};
    minimiser.start(crystal);
    const MolecularEnergy first = minimiser.energy().energy;
    while (minimiser.step()) REQUIRE(minimiser.steps() < 500);
    const MolecularEnergy last = minimiser.energy().energy;
    const double off_A = rmsd_A(*body, m, minimiser.pose());
    MESSAGE(dielectric, ": ", off_A, " A in ", minimiser.steps(), " steps, felt ", first.felt_kcal_mol, " to ",
            last.felt_kcal_mol, " kcal/mol, van der Waals ", last.parts[EnergyPart::VanDerWaals], ", electrostatic ",
            last.parts[EnergyPart::Electrostatic]);
    CHECK(last.felt_kcal_mol < first.felt_kcal_mol);
    CHECK(off_A < 1.0);
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return glm::normalize(Vec3(normal(random), normal(random), normal(random))); };
    int back = 0, lower = 0;
    for (int k = 0; k < 40; ++k) {
      minimiser.start({{crystal.place.A + 0.5 * direction()}, glm::angleAxis(15.0 * 3.14159265 / 180.0, direction())});
      while (minimiser.step()) REQUIRE(minimiser.steps() < 1000);
      back += rmsd_A(*body, m, minimiser.pose()) < 1.0;
      lower += minimiser.energy().energy.felt_kcal_mol < last.felt_kcal_mol - 0.5;
    }
    MESSAGE(dielectric, ": ", back, " of 40 came within 1 A, ", lower, " lower than from the crystal's pose");
    CHECK(back == 40);
    CHECK(lower == 0);
  }
}
