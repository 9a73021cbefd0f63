// Options of the headless commands that choose how a molecule is drawn. They have the same names as the keys of a
// scene.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/commands/atoms_option.h"
#include "engine/molecule/molecule.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct LookOptions {
  std::string style = "spheres", hide, colour;
  ExcludedAtoms left_out;

  /// Adds --style, --hide, --untouchable, --remove and --colour. This object must outlive the parsing.
  void addTo(CLI::App& command);
  /// The look that the options describe. Throws CLI::ValidationError with the option's name if a value is invalid.
  AtomsLook look(const Molecule& molecule, const ColouringInput& colours = {}) const;
  /// The colouring of --colour. Without the option, colours by chain or by element.
  ColourBy colourBy(const Molecule& molecule) const;
};

}  // namespace moltact
