#include "engine/render/atom_style.h"

#include <array>
#include <optional>

#include "engine/molecule/elements.h"

namespace moltact {
namespace {

constexpr Colour rgb(int red, int green, int blue) { return Colour(float(red), float(green), float(blue)) / 255.0f; }

// The eight colours of Okabe and Ito; black is too dark for shading, so carbon is grey.
Colour safeColour(std::uint8_t atomic_number) {
  switch (atomic_number) {
    case 1:
      return rgb(240, 240, 240);
    case 6:
      return rgb(110, 110, 110);
    case 7:
      return rgb(0, 114, 178);
    case 8:
      return rgb(213, 94, 0);
    case 9:
    case 17:
    case 35:
    case 53:
      return rgb(86, 180, 233);
    case 15:
      return rgb(204, 121, 167);
    case 16:
      return rgb(240, 228, 66);
    case 26:
      return rgb(0, 158, 115);
    default:
      return rgb(230, 159, 0);
  }
}

// The four main elements of a protein, chosen by eye; the others keep their hues.
std::optional<Colour> calmColour(std::uint8_t atomic_number) {
  switch (atomic_number) {
    case 1:
      return rgb(235, 235, 232);
    case 6:
      return rgb(178, 180, 178);
    case 7:
      return rgb(122, 144, 214);
    case 8:
      return rgb(214, 112, 104);
    case 16:
      return rgb(226, 204, 104);
    default:
      return std::nullopt;
  }
}

// Keeps shading visible.
Colour softened(const Colour& pure) { return pure * 0.88f + 0.05f; }

// Paul Tol's "bright" scheme of 2018, starting with colours far from that of targets.
constexpr std::array kChains{rgb(68, 119, 170),  rgb(34, 136, 51),  rgb(170, 51, 119), rgb(102, 204, 238),
                             rgb(238, 102, 119), rgb(204, 187, 68), rgb(187, 187, 187)};

}  // namespace

static_assert(kChains.size() == kChainColours);

// Paler than the scheme, like the element colours of large molecules.
Colour chainColour(std::uint32_t chain) { return glm::mix(kChains[chain % kChains.size()], Colour(1.0f), 0.25f); }

ElementColours shownColours(ElementColours wanted, std::size_t atoms) {
  constexpr std::size_t kMany = 300;
  return wanted == ElementColours::Customary && atoms >= kMany ? ElementColours::Calm : wanted;
}

Colour elementColour(std::uint8_t atomic_number, ElementColours colours) {
  if (colours == ElementColours::ColourBlindSafe) return softened(safeColour(atomic_number));
  if (colours == ElementColours::Calm)
    if (const auto calm = calmColour(atomic_number)) return *calm;
  const auto& rgb = element(atomic_number).colour;
  const Colour pure = Colour(rgb[0], rgb[1], rgb[2]) / 255.0f;
  const float grey = glm::dot(pure, Colour(0.30f, 0.59f, 0.11f));
  return glm::mix(Colour(grey), pure, 0.80f) * 0.86f + 0.09f;
}

}  // namespace moltact
