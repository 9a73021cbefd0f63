#include "engine/molecule/draw_style.h"

#include <algorithm>
#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kStyles{
    DrawStyleInfo{DrawStyle::Spheres, "spheres", NC_("style of the picture", "Spheres"),
                  N_("the atoms as balls of their van der Waals radii: what is felt")},
    DrawStyleInfo{DrawStyle::Cartoon, "cartoon", NC_("style of the picture", "Cartoon"),
                  N_("helices, strands and loops of a protein and the ladder of a nucleic acid; all else as sticks")},
    DrawStyleInfo{DrawStyle::BallAndStick, "ball-and-stick", NC_("style of the picture", "Balls and sticks"),
                  N_("small balls, and a stick for each bond")},
    DrawStyleInfo{DrawStyle::Sticks, "sticks", NC_("style of the picture", "Sticks"), N_("a stick for each bond")},
    DrawStyleInfo{DrawStyle::Lines, "lines", NC_("style of the picture", "Lines"), N_("a thin line for each bond")},
    DrawStyleInfo{DrawStyle::Surface, "surface", NC_("style of the picture", "Surface"),
                  N_("the molecular surface that the scene's probe can reach (solvent-excluded)")},
};

}  // namespace

const char* DrawStyleInfo::shownLabel() const { return trc("style of the picture", label); }

std::span<const DrawStyleInfo> drawStyles() { return kStyles; }

std::string_view nameOf(DrawStyle style) {
  return std::find_if(kStyles.begin(), kStyles.end(), [&](const DrawStyleInfo& s) { return s.style == style; })->name;
}

const DrawStyleInfo* findDrawStyle(std::string_view name) {
  const auto at = std::find_if(kStyles.begin(), kStyles.end(), [&](const DrawStyleInfo& s) { return s.name == name; });
  return at == kStyles.end() ? nullptr : &*at;
}

}  // namespace moltact
