// The options of the headless commands that say how a molecule is drawn, as the keys of a scene do.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/commands/atoms_option.h"
#include "engine/molecule/molecule.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct LookOptions {
  std::string style = "spheres", hide, colour;
  LeftOutAtoms left_out;

  /// Adds --style, --hide, --untouchable, --remove and --colour. It must outlive the parsing.
  void addTo(CLI::App& command);
  /// As the options say. Throws CLI::ValidationError with the option's name where one is not sound.
  AtomsLook look(const Molecule& molecule) const;
  /// By chain or element, where no other colouring is asked for.
  ColourBy colourBy(const Molecule& molecule) const;
};

}  // namespace moltact
