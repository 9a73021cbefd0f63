// The options of the headless commands that say what a scene of a lesson says by keys of the same names, beside those of
// look_options.h.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/commands/molecule_argument.h"
#include "engine/lesson/lesson.h"

namespace moltact {

struct SceneOptions {
  std::string mark, highlight, distance, angle, hydrogen_bonds, then, state = "0%";
  std::string label, arrow, captions, view, magnify, in_hand;

  /// Adds what is of the molecule itself, wherever it is seen from: --mark, --highlight, --distance, --angle,
  /// --hydrogen-bonds, --then and --state. It must outlive the parsing, as for addPictures().
  void addMolecules(CLI::App& command);
  /// Adds what only a picture has: --label, --arrow, --captions, --magnify and --in-hand; and --view, which is returned.
  CLI::Option* addPictures(CLI::App& command);

  /// The molecule on its way to the structure of --then, which is read as the first was. Throws CLI::ValidationError with
  /// the option's name where one is not sound, CommandError where the structure cannot be had.
  Molecule atState(Molecule molecule, const MoleculeArgument& read) const;
  /// All else as a scene of a lesson with these keys has it. Throws CLI::ValidationError with the option's name where one is
  /// not sound for this molecule.
  SceneSpec scene(const Molecule& molecule) const;
};

}  // namespace moltact
