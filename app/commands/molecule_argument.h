// The argument MOLECULE of the headless commands, a file or the name of a molecule in the library, and the options for
// reading it.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

struct MoleculeArgument {
  NamedMolecule named;

  /// Adds MOLECULE and the reading options --model, --waters and --assembly. This object must outlive the parsing.
  /// Returns the option of MOLECULE, which is required.
  CLI::Option* addTo(CLI::App& command);
  /// Reads the molecule. Throws CommandError with the problem's text.
  Molecule load() const;

 private:
  void textOption(CLI::App& command, const std::string& name, const ReadingOption& reading);
};

}  // namespace moltact
