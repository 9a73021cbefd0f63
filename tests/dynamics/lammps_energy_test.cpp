// OpenMM's energy of a prepared molecule against that of LAMMPS, an independent program, at the same positions. Where
// one of them is missing the test says that it did not run.
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/dynamics/simulation_engines.h"
#include "engine/molecule/reader.h"
#include "engine/platform/folders.h"
#include "tests/dynamics/child_program.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "OpenMM's and LAMMPS's energy of alanine dipeptide agree within 1e-5 kcal/mol, at its minimum and at 4 moments of "
    "a run of 300 K, 0.4 ps apart") {
  if (lacksProgram("lmp", "lammps") || lacksProgram("python3", "python3")) return;
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("moltact-energy-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const fs::path system = moleculesFolder() / "alanine-dipeptide.xml";
  const auto molecule = readMolecule(moleculesFolder() / "alanine-dipeptide.pdb");
  REQUIRE(molecule);
  MdStart start;
  start.platform = "Reference";
  const auto engine = simulationOf(system, *molecule, start);
  if (!engine) {
    MESSAGE("not run: ", engine.problem().text());
    return;
  }
  double least = 1e9, most = -1e9;
  for (int moment = 0; moment < 5; ++moment) {
    if (moment > 0) REQUIRE((*engine)->advance(100).empty());
    std::FILE* places = std::fopen((folder / "places").c_str(), "w");
    REQUIRE(places);
    for (const Vec3& v : (*engine)->positions_A()) std::fprintf(places, "%.10f %.10f %.10f\n", v.x, v.y, v.z);
    std::fclose(places);
    const std::string command = "python3 '" MOLTACT_SOURCE_DIR "/tests/dynamics/lammps_of_openmm.py' '" +
                                system.string() + "' '" + (folder / "places").string() + "' '" + folder.string() +
                                "' && cd '" + folder.string() + "' && lmp -in in.system -log none > out 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    std::ifstream in(folder / "out");
    double energy = 0.0;
    for (std::string line; std::getline(in, line);)
      if (line.starts_with("energy ")) energy = std::stod(line.substr(7));
    const double own = (*engine)->energies().potential_kcal_mol;
    CHECK(std::abs(energy - own) < 1e-5);
    least = std::min(least, own);
    most = std::max(most, own);
  }
  MESSAGE("energies from ", least, " to ", most, " kcal/mol");
  CHECK(most > least + 1.0);
  std::error_code error;
  fs::remove_all(folder, error);
}
