// Reads molecules of the library for tests.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "engine/molecule/reader.h"

namespace moltact::test {

inline std::string libraryText(const std::string& file) {
  std::ostringstream out;
  out << std::ifstream(std::filesystem::path(MOLTACT_SOURCE_DIR) / "molecules" / file, std::ios::binary).rdbuf();
  return out.str();
}

inline Molecule moleculeOf(const std::string& text, const std::string& name = "x.pdb",
                           const ReadOptions& options = {}) {
  auto molecule = readMoleculeBytes(text, name, options);
  if (!molecule) FAIL(molecule.problem().text());
  return *std::move(molecule);
}

inline Molecule libraryMolecule(const std::string& file, const ReadOptions& options = {}) {
  return moleculeOf(libraryText(file), file, options);
}

}  // namespace moltact::test
