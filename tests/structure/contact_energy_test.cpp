// The Lennard-Jones energy at which the contact stops a held atom or a probe. Its distances are radii, not energies;
// docs/forces.md states the energies that they stand at. The formula here is the test's own.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

#include "engine/structure/amber/pair_atoms.h"
#include "engine/structure/interaction_input.h"
#include "tests/structure/library.h"

using namespace moltact;

namespace {

// What decides the contact and the energy of a pair of atoms.
struct Touching {
  double half_minimum_A, depth_kcal_mol, radius_A;
  auto operator<=>(const Touching&) const = default;
};

double energy_kcal_mol(const Touching& a, const Touching& b, double apart_A) {
  const double six = std::pow((a.half_minimum_A + b.half_minimum_A) / apart_A, 6.0);
  return std::sqrt(a.depth_kcal_mol * b.depth_kcal_mol) * (six * six - 2.0 * six);
}

struct Range {
  double least, median, most;
  std::size_t pairs;
};

Range atContact(const std::set<Touching>& held, const std::set<Touching>& scene) {
  std::vector<double> energies;
  for (const Touching& a : held)
    for (const Touching& b : scene) energies.push_back(energy_kcal_mol(a, b, a.radius_A + b.radius_A));
  std::sort(energies.begin(), energies.end());
  const std::size_t n = energies.size();
  return {energies.front(), 0.5 * (energies[(n - 1) / 2] + energies[n / 2]), energies.back(), n};
}

std::string row(const char* held, const char* contact, const Range& r) {
  char out[160];
  const auto shown = [](double energy) { return std::round(100.0 * energy) / 100.0 + 0.0; };  // no negative zero
  std::snprintf(out, sizeof out, "| %s | %s | %zu | %.2f | %.2f | %.2f |", held, contact, r.pairs, shown(r.least),
                shown(r.median), shown(r.most));
  return out;
}

}  // namespace

TEST_CASE(
    "the energies of 1HPV's pairs of types at contact, of amprenavir with reduced and with whole radii and of a probe, "
    "are those that docs/forces.md states") {
  const Molecule m = test::libraryMolecule("1hpv.pdb");
  const PairAtoms assigned = pairAtoms(m);
  std::vector<std::uint32_t> ligand;
  std::set<Touching> drug, whole, protein;
  const auto touching = [&](std::uint32_t i, double radius_A) {
    const PairAtom& a = assigned.atoms[i];
    return Touching{double(a.half_minimum_A), double(a.depth_kcal_mol), radius_A};
  };
  for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
    if (m.residues[m.atoms[i].residue].name == "478")
      ligand.push_back(i);
    else
      protein.insert(touching(i, m.spheres[i].radius_A));
  const auto body = heldBody(m, ligand);
  REQUIRE(body);
  CHECK(body->overlap_A == 0.5);
  for (std::size_t k = 0; k < ligand.size(); ++k) {
    CHECK(body->spheres[k].radius_A == doctest::Approx(m.spheres[ligand[k]].radius_A - 0.5));
    drug.insert(touching(ligand[k], body->spheres[k].radius_A));
    whole.insert(touching(ligand[k], m.spheres[ligand[k]].radius_A));
  }
  TouchSetup touch;
  touch.forces = "all";
  const auto probe_field = pairField(touch, m, SphereGrid(m.spheres), nullptr);
  REQUIRE(probe_field);
  REQUIRE(probe_field->held.size() == 1);
  const PairAtom& water = probe_field->held.front();
  const std::set<Touching> probe{{double(water.half_minimum_A), double(water.depth_kcal_mol), touch.probe_A}};
  const Range reduced = atContact(drug, protein), bare = atContact(whole, protein),
              by_probe = atContact(probe, protein);
  // Reduced by half an angstrom the contact lies on the rising side of every pair, and by whole radii near the minimum.
  CHECK(reduced.least > 0.0);
  CHECK(bare.median < 0.5 * reduced.median);
  std::ostringstream page;
  page << std::ifstream(MOLTACT_SOURCE_DIR "/docs/forces.md").rdbuf();
  for (const std::string& stated :
       {row("atoms of amprenavir", "radii - 0.5 Å (a held body)", reduced),
        row("atoms of amprenavir", "whole radii", bare), row("a probe of 1.4 Å", "whole radii", by_probe)}) {
    MESSAGE(stated);
    CHECK_MESSAGE(page.str().find(stated) != std::string::npos, "docs/forces.md lacks: ", stated);
  }
}
