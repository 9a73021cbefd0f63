// How an atom looks: the one place where element colours enter a picture. Pure function, every thread.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace moltact {

/// A colour as on the screen (sRGB), 0 to 1 each.
using Colour = glm::vec3;

/// Atoms by index, ascending; shared and never changed, so that pictures are compared by its address.
using AtomList = std::shared_ptr<const std::vector<std::uint32_t>>;

/// Which colours tell elements apart.
enum class ElementColours : std::uint8_t {
  Customary,        ///< carbon grey, oxygen red, nitrogen blue, as chemists know them
  ColourBlindSafe,  ///< as near to them as the palette of Okabe and Ito (2008) allows, which every kind of colour
                    ///< vision tells apart
  Calm,             ///< the customary hues, lighter and paler, for molecules of many atoms
};

/// The meaning of an atom's colour.
enum class ColourBy : std::uint8_t {
  Element,
  Chain,  ///< its chain; what is no protein and no nucleic acid keeps its element's colour
};

/// The element's colour (engine/molecule/elements.h), softened so that light and shade stay visible on it.
/// `atomic_number` 0 or beyond the table gives the colour of the unknown element.
Colour elementColour(std::uint8_t atomic_number, ElementColours colours = ElementColours::Customary);

/// The colours in which a molecule of so many atoms is shown where these are wanted: hundreds of strong reds and blues
/// hide the shape.
ElementColours shownColours(ElementColours wanted, std::size_t atoms);

/// The colour of a molecule's chain, counted from 0: seven that every kind of colour vision tells apart, then again
/// from the first.
Colour chainColour(std::uint32_t chain);
/// After so many chains their colours begin again.
inline constexpr std::size_t kChainColours = 7;

}  // namespace moltact
