// The legend of a picture's atom colours, for the window and for saved pictures. Pure except for reading the fonts'
// files; any thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/render/picture.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct LegendEntry {
  Colour colour;
  std::string name;
};

/// Lists marks with names, then the meaning of the colours: the legend of a scheme, else chains in their order or
/// elements by decreasing frequency. The length is limited. Chains with repeated colours are omitted, and each colour
/// has one line. Atoms that are not drawn are ignored. Ribbons have entries for chains; elements appear only if atoms
/// under the probe are drawn as spheres.
std::vector<LegendEntry> legendOf(const Molecule& molecule, ColourBy by, ElementColours elements,
                                  const AtomsLook& look);

/// Caches the legend for a window that requests it in every frame; recomputes it after a change. Window's thread.
class LegendMemory {
 public:
  const std::vector<LegendEntry>& of(std::shared_ptr<const Molecule> molecule, ColourBy by, ElementColours elements,
                                     const AtomsLook& look);

 private:
  std::shared_ptr<const Molecule> molecule_;
  ColourBy by_ = ColourBy::Element;
  ElementColours elements_ = ElementColours::Customary;
  AtomsLook look_;
  std::string language_;
  std::vector<LegendEntry> entries_;
};

/// Draws the legend into the upper left corner of the scene's picture. `unit_px`: size of a pixel of 96 dpi. Returns
/// false if no font is installed.
bool paintLegend(Picture& picture, const std::vector<LegendEntry>& entries, const Theme& theme, double unit_px);

}  // namespace moltact
