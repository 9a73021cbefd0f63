// How an atom looks: the one place where element colours enter a picture. Pure function, every thread.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace moltact {

/// A colour as on the screen (sRGB), 0 to 1 each.
using Colour = glm::vec3;

/// The element's colour (engine/molecule/elements.h), softened so that light and shade stay visible on it.
/// `atomic_number` 0 or beyond the table gives the colour of the unknown element.
Colour elementColour(std::uint8_t atomic_number);

}  // namespace moltact
