// The table of engines: what a scene names finds the engine, and what names none is answered with the forms that exist.
#include "engine/dynamics/simulation_engines.h"

#include <doctest/doctest.h>

#include <fstream>
#include <set>

#include "engine/platform/read_file.h"
#include "tests/dynamics/networks.h"
#include "tests/molecule/files.h"

using namespace moltact;

TEST_CASE(
    "each engine either reads files of one ending or has addresses of one scheme, no two share one, and "
    "docs/simulation.md and the reference of lessons name each") {
  const std::filesystem::path source = MOLTACT_SOURCE_DIR;
  const auto page = readFile(source / "docs/simulation.md", 1 << 20, ""),
             reference = readFile(source / "docs/lesson-reference.md", 1 << 20, "");
  REQUIRE(page);
  REQUIRE(reference);
  const std::size_t from = reference->find("| `simulation` |");
  REQUIRE(from != std::string::npos);
  const std::string key = reference->substr(from, reference->find('\n', from) - from);
  std::set<std::string_view> seen;
  for (const SimulationEngine& e : simulationEngines()) {
    CAPTURE(std::string(e.name));
    CHECK((e.make != nullptr) != (e.connect != nullptr));
    CHECK((e.make != nullptr) == e.ending.starts_with('.'));
    CHECK((e.connect != nullptr) == !e.scheme.empty());
    CHECK(e.programs.empty() == e.scheme.empty());
    CHECK(seen.insert(e.make ? e.ending : e.scheme).second);
    CHECK(page->find(e.name) != std::string::npos);
    CHECK(key.find(e.name) != std::string::npos);
  }
  REQUIRE((simulationEngines().front().make != nullptr));
}

TEST_CASE(
    "imd://127.0.0.1:8888 is an address of IMD, peptide.xml none; foo://127.0.0.1:1 and imd://a.host:1 are answered "
    "with imd://HOST:PORT") {
  const auto good = simulationAddress("imd://127.0.0.1:8888");
  REQUIRE(good);
  REQUIRE(*good);
  CHECK((*good)->engine->name == "IMD");
  CHECK((*good)->at.port == 8888);
  CHECK((*good)->text() == "imd://127.0.0.1:8888");
  CHECK_FALSE(simulationAddress("peptide.xml"));
  CHECK_FALSE(simulationAddress(""));
  for (const char* wrong : {"foo://127.0.0.1:1", "imd://a.host:1", "imd://", "://1"}) {
    CAPTURE(std::string(wrong));
    const auto answer = simulationAddress(wrong);
    REQUIRE(answer);
    REQUIRE_FALSE(*answer);
    CHECK(answer->problem().remedy.find("imd://HOST:PORT") != std::string::npos);
  }
}

TEST_CASE("a system of an unknown ending is refused with the endings that exist; beside a molecule the .xml is found") {
  const test::Scratch scratch;
  const Molecule molecule = test::libraryMolecule("alanine-dipeptide.pdb");
  std::ofstream(scratch.folder / "a.foo") << "system";
  const auto none = simulationOf(scratch.folder / "a.foo", molecule, {});
  REQUIRE_FALSE(none);
  CHECK(none.problem().file == "a.foo");
  CHECK(none.problem().remedy.find("OpenMM (.xml)") != std::string::npos);
  CHECK(systemBeside(scratch.folder / "a.pdb") == scratch.folder / "a.xml");
}
