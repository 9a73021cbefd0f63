#include "engine/render/atom_style.h"

#include "engine/molecule/elements.h"

namespace moltact {

Colour elementColour(std::uint8_t atomic_number) {
  const auto& rgb = element(atomic_number).colour;
  const Colour pure = Colour(rgb[0], rgb[1], rgb[2]) / 255.0f;
  const float grey = glm::dot(pure, Colour(0.30f, 0.59f, 0.11f));
  return glm::mix(Colour(grey), pure, 0.80f) * 0.86f + 0.09f;
}

}  // namespace moltact
