#include "engine/haptics/texture_choices.h"

#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kTextures{
    OfferedWord{kNoTexture, N_("Even"), N_("the same friction everywhere")},
    OfferedWord{kElementTexture, N_("Element"),
                N_("oxygen drags 1.75 times as much as carbon, nitrogen and phosphorus 1.5 times, sulfur 0.5 times, "
                   "hydrogen 0.75 times")},
    OfferedWord{kHydrophobicityTexture, N_("Residue"),
                N_("amino acids that like water drag up to 1.75 times as much, those that shun it down to 0.25 times")},
    OfferedWord{kChargeTexture, N_("Charge"),
                N_("positive side chains at pH 7 drag 1.75 times as much, negative ones and phosphates 0.25 times")},
};

}  // namespace

std::span<const OfferedWord> textureChoices() { return kTextures; }

}  // namespace moltact
