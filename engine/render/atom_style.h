// How an atom looks: the one place where element colours enter a picture. Pure function, every thread.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace moltact {

/// A colour as on the screen (sRGB), 0 to 1 each.
using Colour = glm::vec3;

/// The colour of an element in the CPK convention (H white, C grey, N blue, O red, S yellow, P orange, halogens green…),
/// softened so that shading stays visible on it. `atomic_number` 0 or unlisted gives a pale violet.
Colour elementColour(std::uint8_t atomic_number);

}  // namespace moltact
