#include "engine/molecule/draw_style.h"

#include <algorithm>
#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kStyles{
    DrawStyleInfo{.style = DrawStyle::Spheres,
                  .name = "spheres",
                  .label = NC_("style of the picture", "Spheres"),
                  .sentence = N_("the atoms as spheres of their van der Waals radii, as they are felt"),
                  .hides_places = true},
    DrawStyleInfo{.style = DrawStyle::Cartoon,
                  .name = "cartoon",
                  .label = NC_("style of the picture", "Cartoon"),
                  .sentence = N_("helices, strands and loops of a protein and the ladder of a nucleic acid; all else "
                                 "as sticks")},
    DrawStyleInfo{.style = DrawStyle::BallAndStick,
                  .name = "ball-and-stick",
                  .label = NC_("style of the picture", "Balls and sticks"),
                  .sentence = N_("small spheres, and a stick for each bond")},
    DrawStyleInfo{.style = DrawStyle::Sticks,
                  .name = "sticks",
                  .label = NC_("style of the picture", "Sticks"),
                  .sentence = N_("a stick for each bond")},
    DrawStyleInfo{.style = DrawStyle::Lines,
                  .name = "lines",
                  .label = NC_("style of the picture", "Lines"),
                  .sentence = N_("a thin line for each bond")},
    DrawStyleInfo{.style = DrawStyle::Surface,
                  .name = "surface",
                  .label = NC_("style of the picture", "Surface"),
                  .sentence = N_("the molecular surface that the scene's probe can reach (solvent-excluded)"),
                  .uses_probe = true,
                  .hides_places = true},
};

template <DrawStyle style>
constexpr const DrawStyleInfo& row() {
  constexpr auto at =
      std::find_if(kStyles.begin(), kStyles.end(), [](const DrawStyleInfo& s) { return s.style == style; });
  static_assert(at != kStyles.end(), "a style has no row in kStyles");
  return *at;
}

}  // namespace

const char* DrawStyleInfo::shownLabel() const { return trc("style of the picture", label); }

std::span<const DrawStyleInfo> drawStyles() { return kStyles; }

const DrawStyleInfo& infoOf(DrawStyle style) {
  switch (style) {
    case DrawStyle::Spheres:
      return row<DrawStyle::Spheres>();
    case DrawStyle::Cartoon:
      return row<DrawStyle::Cartoon>();
    case DrawStyle::BallAndStick:
      return row<DrawStyle::BallAndStick>();
    case DrawStyle::Sticks:
      return row<DrawStyle::Sticks>();
    case DrawStyle::Lines:
      return row<DrawStyle::Lines>();
    case DrawStyle::Surface:
      return row<DrawStyle::Surface>();
  }
  return kStyles.front();
}

const DrawStyleInfo* findDrawStyle(std::string_view name) {
  const auto at = std::find_if(kStyles.begin(), kStyles.end(), [&](const DrawStyleInfo& s) { return s.name == name; });
  return at == kStyles.end() ? nullptr : &*at;
}

}  // namespace moltact
