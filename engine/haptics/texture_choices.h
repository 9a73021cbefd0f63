// What the friction of the surface depends on: the words of the property "texture" (touch_setup.h). Plain data, every
// thread.
#pragma once

#include <span>
#include <string_view>

#include "engine/core/offered_word.h"

namespace moltact {

/// All textures, the default first. engine/structure/roughness.h computes the factors of each.
std::span<const OfferedWord> textureChoices();

inline constexpr std::string_view kNoTexture = "none", kElementTexture = "element",
                                  kHydrophobicityTexture = "hydrophobicity", kChargeTexture = "charge";

}  // namespace moltact
