// `moltact simulate` as users call it. Where OpenMM or its Python layer is missing the tests check the message instead,
// and say so.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "engine/platform/folders.h"
#include "tests/app/command_place.h"

using namespace moltact::test;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE(
    "prepare adds 102 hydrogens to the helix of 20 alanines and completes a chain that was cut; run simulates what it "
    "made; a molecule without parameters and a packed file leave nothing") {
  const CommandPlace place;
  const bool layer = std::system("/usr/bin/python3 -c 'import openmm' 2>/dev/null") == 0;
  const Run helix = place.run("simulate prepare alpha-helix --out helix.xml");
  if (!layer) {
    MESSAGE("not run: this computer's /usr/bin/python3 has no module openmm");
    if (helix.status != 0) CHECK(has(helix.err, "python3-simtk"));
    return;
  }
  REQUIRE_MESSAGE(helix.status == 0, helix.err);
  CHECK(has(helix.out, "203 atoms"));
  CHECK(has(contents(place.folder / "helix.xml"), "<System"));
  const std::string whole = contents(place.folder / "helix.pdb");
  std::size_t oxygens = 0, atoms = 0;
  for (std::size_t at = whole.find("\nATOM"); at != std::string::npos; at = whole.find("\nATOM", at + 1)) {
    ++atoms;
    if (whole.substr(at + 13, 4) == " OXT") ++oxygens;
  }
  CHECK(atoms == 203);
  CHECK(oxygens == 1);
  const Run run = place.run("simulate run helix.pdb --ps 0.1");
  if (run.status == 0) {
    CHECK(has(run.out, "203 atoms"));
    CHECK(has(run.out, "steps of 4 fs"));
    CHECK(has(run.out, "steps per second"));
  } else {
    MESSAGE("not run: ", run.err);
    CHECK(has(run.err, "moltact-openmm"));
  }
  // Three residues of it: 15 atoms, an oxygen for the cut end and 17 hydrogens.
  std::ifstream from(moltact::moleculesFolder() / "alpha-helix.pdb");
  std::ofstream cut(place.folder / "cut.pdb");
  for (std::string line; std::getline(from, line);)
    if (line.starts_with("ATOM") && std::stoi(line.substr(22, 4)) <= 3) cut << line << '\n';
  cut.close();
  const Run short_one = place.run("simulate prepare cut.pdb");
  CHECK_MESSAGE(short_one.status == 0, short_one.err);
  CHECK(has(short_one.out, "cut-simulated.xml, cut-simulated.pdb: 33 atoms"));
  const Run benzene = place.run("simulate prepare benzene --out benzene.xml");
  CHECK(benzene.status == 1);
  CHECK(has(benzene.err, "benzene.pdb cannot be prepared: the force field does not fit"));
  CHECK_FALSE(std::filesystem::exists(place.folder / "benzene.xml"));
  std::ofstream(place.folder / "packed.pdb.gz") << "x";
  const Run packed = place.run("simulate prepare packed.pdb.gz");
  CHECK(packed.status == 1);
  CHECK(has(packed.err, "is not a PDB or mmCIF file"));
  CHECK(place.run("simulate prepare alpha-helix --out helix.txt").status != 0);
}

TEST_CASE(
    "gromacs prepares the helix of 20 alanines: the structure that its server will send has 203 atoms; without "
    "GROMACS, "
    "a message names the package") {
  const CommandPlace place;
  const Run run = place.run("simulate gromacs alpha-helix --prepare-only --out helix.gro");
  if (std::system("command -v gmx >/dev/null 2>&1") != 0) {
    MESSAGE("not run: the program gmx is not installed (Debian: gromacs)");
    CHECK(run.status == 1);
    CHECK(has(run.err, "install the package gromacs"));
    return;
  }
  REQUIRE_MESSAGE(run.status == 0, run.err);
  CHECK(has(run.out, "helix.gro, helix.tpr"));
  CHECK(has(contents(place.folder / "helix.gro"), "\n  203\n"));
  CHECK(std::filesystem::file_size(place.folder / "helix.tpr") > 10'000);
  CHECK(place.run("simulate gromacs benzene --prepare-only").status == 1);
  CHECK(place.run("simulate gromacs alpha-helix --prepare-only --out helix.txt").status != 0);
}

TEST_CASE("run without a system beside the molecule says which file is missing") {
  const CommandPlace place;
  const Run run = place.run("simulate run benzene");
  CHECK(run.status == 1);
  CHECK(has(run.err, "benzene.xml"));
}
