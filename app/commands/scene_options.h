// Options of the headless commands that have the names and meanings of a lesson scene's keys, in addition to those of
// look_options.h.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/commands/molecule_argument.h"
#include "engine/lesson/lesson.h"

namespace moltact {

struct SceneOptions {
  std::string mark, highlight, distance, angle, hydrogen_bonds, then, state = "0%";
  std::string trajectory;
  int frame = 1;
  std::string label, arrow, captions, view, magnify, in_hand;

  /// Adds the options that belong to the molecule and not to the view: --mark, --highlight, --distance, --angle,
  /// --hydrogen-bonds, --then, --state, --trajectory and --frame. This object must outlive the parsing, also for addPictures().
  void addMolecules(CLI::App& command);
  /// Adds the options that only a picture has: --label, --arrow, --captions, --magnify, --in-hand and --view. Returns
  /// --view.
  CLI::Option* addPictures(CLI::App& command);

  /// Moves the molecule toward the structure of --then, which is read with the same options, by the share in --state, or
  /// to the frame of a trajectory.
  /// Throws CLI::ValidationError with the option's name if a value is invalid, and CommandError if the structure cannot
  /// be loaded.
  Molecule atState(Molecule molecule, const MoleculeArgument& read) const;
  /// The fluctuation of each atom in the trajectory, of at most kMaxSurveyed frames (unit: angstrom); empty without one.
  std::vector<float> fluctuation_A(const Molecule& molecule) const;
  static constexpr std::size_t kMaxSurveyed = 400;
  /// A lesson scene with the keys of all other options. Throws CLI::ValidationError with the option's name if a value
  /// is invalid for this molecule.
  SceneSpec scene(const Molecule& molecule) const;
};

}  // namespace moltact
