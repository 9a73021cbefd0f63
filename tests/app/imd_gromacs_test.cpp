// Real GROMACS as the server of what `moltact simulate gromacs` prepares, where the program gmx is installed; else the
// test says that it did not run. Oracle: a spring in a bath of 300 K, whose end an atom leaves by sqrt(3 kT/k) on
// average, 0.94 A for 2 kcal/mol/A^2.
#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "engine/dynamics/imd/imd_simulation.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/platform/folders.h"
#include "tests/app/command_place.h"
#include "tests/dynamics/child_program.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// GROMACS listens on a port of its choice, which it prints.
std::uint16_t portIn(const std::filesystem::path& log) {
  const std::string words = "Listening for IMD connection on port ";
  for (int k = 0; k < 6000; ++k) {
    const std::string text = contents(log);
    if (const std::size_t at = text.find(words); at != std::string::npos && text.find('.', at) != std::string::npos)
      return std::uint16_t(std::stoi(text.substr(at + words.size())));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  FAIL(contents(log));
  return 0;
}

}  // namespace

TEST_CASE(
    "real GROMACS: the first atom of a helix, pulled by 10 A, comes within 2 A of the end of the spring; another "
    "client "
    "after us connects; killed, the session ends with a sentence") {
  if (!hasProgram("gmx")) {
    MESSAGE("not run: the program gmx is not installed (Debian: gromacs)");
    return;
  }
  const CommandPlace place;
  const Run made = place.run("simulate gromacs alpha-helix --prepare-only --out helix.gro");
  REQUIRE_MESSAGE(made.status == 0, made.err);
  const auto molecule = readMolecule({place.folder / "helix.gro"});
  REQUIRE(molecule);
  std::vector<Vec3> start_A;
  for (const Sphere& s : molecule->spheres) start_A.push_back(s.centre_A);
  ChildProgram gromacs(
      {"gmx", "mdrun", "-nt", "1", "-s", "helix.tpr", "-deffnm", "run", "-imdport", "0", "-imdwait", "-imdpull"},
      place.folder.string(), "log");
  const TcpAddress address{"127.0.0.1", portIn(place.folder / "log")};
  auto live = ImdSimulation::connect(address, start_A, nullptr);
  REQUIRE_MESSAGE(live, live.problem().text());
  SimulationCommand wanted;
  const Vec3 outward = glm::normalize(start_A[0] - start_A[start_A.size() / 2]);
  const Vec3 end_A = start_A[0] + 10.0 * outward;
  wanted.pushes.push_back({0, end_A, Vec3(0.0), 2.0});
  double nearest_A = 1e9;
  for (int k = 0; k < 60'000 && nearest_A > 2.0; ++k) {
    (*live)->command(wanted);
    nearest_A = std::min(nearest_A, glm::distance((*live)->newest().positions_A[0], end_A));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK(nearest_A <= 2.0);
  CHECK((*live)->newest().has_temperature);
  CHECK_FALSE((*live)->newest().dead);
  // Some frames are still on the way when it pauses.
  wanted.pushes.clear();
  const auto framesIn = [&](int reads) {
    const std::uint64_t before = (*live)->newest().serial;
    for (int k = 0; k < reads; ++k) {
      (*live)->command(wanted);
      (*live)->newest();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return (*live)->newest().serial - before;
  };
  wanted.running = false;
  bool still = false;
  for (int k = 0; k < 300 && !still; ++k) still = framesIn(200) == 0;
  CHECK(still);
  wanted.running = true;
  bool moves = false;
  for (int k = 0; k < 300 && !moves; ++k) moves = framesIn(200) > 0;
  CHECK(moves);
  live->reset();
  live = ImdSimulation::connect(address, start_A, nullptr);
  REQUIRE_MESSAGE(live, live.problem().text());
  gromacs.kill();
  for (int k = 0; k < 60'000 && !(*live)->newest().dead; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK((*live)->newest().fault.find("lost") != std::string::npos);
}
