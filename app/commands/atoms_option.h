// Options of the headless commands that select atoms.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

/// Returns the atoms of a selection in ascending order; an empty text selects none. Throws CLI::ValidationError with
/// the option's name if the text is not a selection or selects no atom.
std::vector<std::uint32_t> selectedAtoms(const char* option, const std::string& text, const Molecule& molecule);

/// The error of --in-hand for a selection of more atoms than a hand can hold.
CLI::ValidationError tooManyHeld(std::size_t atoms);

/// The options --untouchable (drawn but not felt) and --remove (neither drawn nor felt).
struct ExcludedAtoms {
  std::string untouchable, remove;

  /// Adds both options. This object must outlive the parsing.
  void addTo(CLI::App& command);
  /// The atoms that are not felt, in ascending order. Throws as selectedAtoms() does.
  std::vector<std::uint32_t> notFelt(const Molecule& molecule) const;
  /// The atoms that are not drawn either.
  std::vector<std::uint32_t> removed(const Molecule& molecule) const {
    return selectedAtoms("--remove", remove, molecule);
  }
};

}  // namespace moltact
