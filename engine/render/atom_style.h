// The appearance of atoms; the only place where element colours enter a picture. Pure functions, every thread.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace moltact {

/// An sRGB colour, components 0 to 1.
using Colour = glm::vec3;

/// Atom indices, ascending; shared and immutable, so pictures compare it by address.
using AtomList = std::shared_ptr<const std::vector<std::uint32_t>>;

/// The palette that distinguishes elements.
enum class ElementColours : std::uint8_t {
  Customary,  ///< carbon grey, oxygen red, nitrogen blue: the convention of chemistry
  /// As close to the convention as the palette of Okabe and Ito (2008) permits, which all types of colour vision can
  /// distinguish.
  ColourBlindSafe,
  Calm,  ///< the conventional hues, lighter and paler, for molecules of many atoms
};

/// The meaning of an atom's colour.
enum class ColourBy : std::uint8_t {
  Element,
  Chain,  ///< the atom's chain; atoms outside proteins and nucleic acids keep the colour of their element
};

/// The element's colour (engine/molecule/elements.h), softened so that shading remains visible. An `atomic_number` of 0
/// or beyond the table gives the colour of the unknown element.
Colour elementColour(std::uint8_t atomic_number, ElementColours colours = ElementColours::Customary);

/// The palette used for a molecule with this number of atoms when `wanted` is selected. Large molecules get the calm
/// palette, because hundreds of saturated reds and blues hide the shape.
ElementColours shownColours(ElementColours wanted, std::size_t atoms);

/// The colour of a molecule's chain, counted from 0: seven colours that all types of colour vision can distinguish,
/// repeated cyclically.
Colour chainColour(std::uint32_t chain);
/// Number of distinct chain colours.
inline constexpr std::size_t kChainColours = 7;

}  // namespace moltact
