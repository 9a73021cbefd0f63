// Oracle: OpenMM (Debian's packages python3-simtk or python3-openmm), which computes the energies of complexes of Debian's
// package apbs-data with the parameters that ours have.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/haptics/field/pair_sum.h"
#include "engine/platform/temporary_folder.h"
#include "engine/structure/amber/pair_atoms.h"
#include "tests/structure/library.h"

using namespace moltact;

namespace {

const std::filesystem::path kComplexes = "/usr/share/apbs/examples";
// Debian's modules belong to its own Python.
constexpr const char* kPython = "/usr/bin/python3";

struct Complex {
  const char *name, *scene, *body;
};
constexpr Complex kPairs[] = {
    {"fasciculin on acetylcholinesterase", "misc/mache.pqr", "misc/fas2.pqr"},
    {"barstar near barnase", "pbsam-barn_bars/barnase.pqr", "pbsam-barn_bars/barstar.pqr"},
    {"a peptide on RNA", "protein-rna/model_outBoxB19.pqr", "protein-rna/model_outNpep.pqr"},
    {"DAPI in DNA's groove", "bem-binding-energy/test_proteins/1d30_monomer1.pqr",
     "bem-binding-energy/test_proteins/1d30_monomer2.pqr"},
};

std::vector<PairAtom> openmmAtomsOf(const char* file) {
  const auto molecule = readMolecule(kComplexes / file, {.waters = true});
  if (!molecule) FAIL(molecule.problem().text());
  CHECK(molecule->charges_e.size() == molecule->atoms.size());
  return pairAtoms(*molecule).atoms;
}

MolecularEnergy ourEnergy(const std::vector<PairAtom>& scene, const std::vector<PairAtom>& body, Dielectric kind,
                          double dielectric, double cutoff_A, double switch_A) {
  std::vector<Sphere> places;
  for (const PairAtom& a : scene) places.push_back({a.centre_A, 1.0});
  PairModel model;
  model.kind = kind;
  model.dielectric = dielectric;
  model.cutoff_A = cutoff_A;
  model.switch_from_A = switch_A;
  model.wall_kcal_mol = INFINITY;
  PairSum sum(std::make_shared<const SphereGrid>(std::move(places)), scene, body, model);
  return sum.at({}).energy;
}

}  // namespace

TEST_CASE(
    "OpenMM and the pair sum agree to 1e-4 in Coulomb and Lennard-Jones energies of four complexes of proteins, RNA, "
    "DNA "
    "and a drug, without a cut-off and with ours, in three dielectrics") {
  if (!std::filesystem::exists(kComplexes / "misc/mache.pqr")) {
    MESSAGE("did not run: Debian's package apbs-data is not installed");
    return;
  }
  if (std::system((std::string(kPython) + " -c 'import openmm' >/dev/null 2>&1").c_str()) != 0 &&
      std::system((std::string(kPython) + " -c 'import simtk.openmm' >/dev/null 2>&1").c_str()) != 0) {
    MESSAGE("did not run: OpenMM's Python module (Debian's package python3-simtk or python3-openmm) is not installed");
    return;
  }
  const auto folder = TemporaryFolder::in(std::filesystem::temp_directory_path(), "moltact-openmm-");
  REQUIRE(folder);
  const std::string script =
      (std::filesystem::path(MOLTACT_SOURCE_DIR) / "tests/structure/openmm_energies.py").string();
  for (const Complex& pair : kPairs) {
    const std::string name = pair.name;
    CAPTURE(name);
    const std::vector<PairAtom> scene = openmmAtomsOf(pair.scene), body = openmmAtomsOf(pair.body);
    const auto in = (folder->path() / "in").string(), out = (folder->path() / "out").string();
    std::ofstream file(in);
    file.precision(17);
    for (const auto* set : {&scene, &body})
      for (const PairAtom& a : *set)
        file << int(set == &body) << ' ' << a.centre_A.x << ' ' << a.centre_A.y << ' ' << a.centre_A.z << ' '
             << double(a.half_minimum_A) << ' ' << double(a.depth_kcal_mol) << ' ' << double(a.charge_e) << '\n';
    file.close();
    const std::string command = std::string(kPython) + " '" + script + "' < '" + in + "' > '" + out + "' 2>/dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    std::ifstream read(out);
    double right[6];
    for (double& value : right) read >> value;
    REQUIRE(bool(read));
    const MolecularEnergy whole = ourEnergy(scene, body, Dielectric::Constant, 1.0, 1000.0, 999.0);
    const MolecularEnergy cut = ourEnergy(scene, body, Dielectric::Constant, 1.0, 10.0, 8.0);
    const double ours[6] = {
        whole.parts[EnergyPart::Electrostatic],
        whole.parts[EnergyPart::VanDerWaals],
        cut.parts[EnergyPart::Electrostatic],
        ourEnergy(scene, body, Dielectric::Distance, 4.0, 10.0, 8.0).parts[EnergyPart::Electrostatic],
        ourEnergy(scene, body, Dielectric::MehlerSolmajer, 4.0, 10.0, 8.0).parts[EnergyPart::Electrostatic],
        cut.parts[EnergyPart::VanDerWaals]};
    double worst = 0.0;
    for (int k = 0; k < 6; ++k) {
      CAPTURE(k);
      CAPTURE(ours[k]);
      CAPTURE(right[k]);
      const double off = std::abs(ours[k] - right[k]) / std::abs(right[k]);
      worst = std::max(worst, off);
      CHECK(right[k] != 0.0);
      CHECK(off < 1e-4);
    }
    MESSAGE(name, ": Coulomb ", right[0], ", Lennard-Jones ", right[1], " kcal/mol; within 10 A ", right[2], ", ",
            right[3], ", ", right[4], " and ", right[5], "; greatest relative difference ", worst);
  }
}
