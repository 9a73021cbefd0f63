// What the colours of a picture's atoms mean, for the window's legend and for one in a saved picture. Pure but for the
// fonts' files; any thread.
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

/// The marks with names, then what the colours tell: of a scheme its legend, else chains in their order and elements from
/// the commonest to the rarest; of these no more than can be read at once. Chains whose colours repeat are left out, and
/// no colour has two lines. Atoms that are not drawn have no part in it; a ribbon tells chains, and elements only where
/// the atoms under the probe come out of it.
std::vector<LegendEntry> legendOf(const Molecule& molecule, ColourBy by, ElementColours elements,
                                  const AtomsLook& look);

/// The same for a window that asks in every frame: counted anew only where what it is of has changed. Window's thread.
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

/// Writes it into the upper left corner of the scene's picture. `unit_px`: a pixel of 96 dpi. False where no font is
/// installed.
bool paintLegend(Picture& picture, const std::vector<LegendEntry>& entries, const Theme& theme, double unit_px);

}  // namespace moltact
