// The argument MOLECULE of the headless commands: a file or the name of a molecule of the library, and how to read it.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

struct MoleculeArgument {
  NamedMolecule named;

  /// Adds MOLECULE, --model, --waters and --assembly. The argument must outlive the parsing.
  void addTo(CLI::App& command);
  /// Reads it. Throws CommandError with the problem's text.
  Molecule load() const;
};

}  // namespace moltact
