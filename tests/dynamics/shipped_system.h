// OpenMM and the shipped system, alanine dipeptide, for tests. Where OpenMM is not installed they say that they did not
// run.
#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <string>

#include "engine/dynamics/openmm_engine.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "tests/structure/library.h"

namespace moltact::test {

/// Null with a message where OpenMM is missing; every other problem fails the test.
inline std::unique_ptr<MdEngine> madeOf(Expected<std::unique_ptr<MdEngine>> made) {
  if (made) return *std::move(made);
  if (made.problem().message.find("cannot be loaded") == std::string::npos) FAIL(made.problem().text());
  MESSAGE("not run: ", made.problem().text());
  return nullptr;
}

inline std::unique_ptr<MdEngine> engineOf(const MdStart& start) { return madeOf(openMMEngine(start, "test.xml")); }

/// On the platform Reference.
inline MdStart shippedSystem() {
  MdStart start;
  auto text = readFile(moleculesFolder() / "alanine-dipeptide.xml", 1 << 20, "");
  REQUIRE(text);
  start.system = *std::move(text);
  for (const Sphere& s : libraryMolecule("alanine-dipeptide.pdb").spheres) start.positions_A.push_back(s.centre_A);
  start.platform = "Reference";
  return start;
}

}  // namespace moltact::test
