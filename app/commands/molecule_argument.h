// The argument MOLECULE that most commands take: a file, or the name of a molecule of the library, and how to read it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "engine/molecule/molecule.h"
#include "engine/molecule/reader.h"

namespace moltact {

struct MoleculeArgument {
  std::string name;
  ReadOptions reading;

  /// Adds MOLECULE and --model, --waters, --assembly. The argument must outlive the parsing.
  void addTo(CLI::App& command);
  /// Reads it; warnings go to stderr. Throws CommandError.
  Molecule load() const;
};

}  // namespace moltact
