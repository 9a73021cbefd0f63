// The argument MOLECULE of the headless commands: a file or the name of a molecule of the library, and how to read it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "engine/molecule/molecule.h"
#include "engine/molecule/reader.h"

namespace moltact {

struct MoleculeArgument {
  std::string name;
  ReadOptions reading;

  /// Adds MOLECULE, --model, --waters and --assembly. The argument must outlive the parsing.
  void addTo(CLI::App& command);
  /// Reads it. Throws CommandError with the problem's text.
  Molecule load() const;
};

}  // namespace moltact
