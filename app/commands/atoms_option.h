// Options of the headless commands that take atoms by selection.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

/// The atoms of a selection, ascending; none for an empty text. Throws CLI::ValidationError with the option's name where it
/// is no selection, or selects nothing.
std::vector<std::uint32_t> selectedAtoms(const char* option, const std::string& text, const Molecule& molecule);

/// For --in-hand: more atoms than a hand can hold.
CLI::ValidationError tooManyHeld(std::size_t atoms);

/// --untouchable and --remove: what a scene takes from the hand, and from hand and eye.
struct LeftOutAtoms {
  std::string untouchable, remove;

  /// The texts must outlive the parsing.
  void addTo(CLI::App& command);
  /// Atoms that are not felt, ascending. Throws as selectedAtoms() does.
  std::vector<std::uint32_t> notFelt(const Molecule& molecule) const;
  /// Atoms that are taken out for the eye too.
  std::vector<std::uint32_t> removed(const Molecule& molecule) const {
    return selectedAtoms("--remove", remove, molecule);
  }
};

}  // namespace moltact
