#include "engine/render/view_scene.h"

#include <algorithm>

namespace moltact {
namespace {

constexpr Colour hex(std::uint32_t rgb) {
  return {float(rgb >> 16 & 255) / 255.0f, float(rgb >> 8 & 255) / 255.0f, float(rgb & 255) / 255.0f};
}

}  // namespace

Colour forceColour(const Theme& theme, double share) {
  const auto t = float(2.0 * std::clamp(share, 0.0, 1.0));
  return t < 1.0f ? glm::mix(theme.force, theme.strong, t) : glm::mix(theme.strong, theme.strongest, t - 1.0f);
}

Theme darkTheme() {
  return {.background_top = hex(0x232B38),
          .background_bottom = hex(0x0D1117),
          .surface = hex(0x7FC4E8),
          .in_use = hex(0xFFD166),
          .hip = hex(0xFF5D8F),
          .scp = hex(0xFFFFFF),
          .probe = hex(0x7FE3F0),
          .force = hex(0x3DDC97),
          .strong = hex(0xFFE45C),
          .strongest = hex(0xFF4D4D),
          .bond = hex(0x7FB2FF),
          .measure = hex(0xF4F1FF),
          .touched = hex(0xB58CFF),
          .target = hex(0xFFB000),
          .attracts = hex(0x62D84E),
          .repels = hex(0xF56FD0),
          .wire_strength = 1.0f,
          .fade = 0.6f};
}

Theme lightTheme() {
  return {.background_top = hex(0xFFFFFF),
          .background_bottom = hex(0xDDE4EC),
          .surface = hex(0x1E5F8C),
          .in_use = hex(0xC2410C),
          .hip = hex(0xD6246E),
          .scp = hex(0x101820),
          .probe = hex(0x00A6B8),
          .force = hex(0x0B8457),
          .strong = hex(0xC9A400),
          .strongest = hex(0xD11F2D),
          .bond = hex(0x1B5FB0),
          .measure = hex(0xF4F1FF),
          .touched = hex(0x8A5CE0),
          .target = hex(0xFF5A00),
          .attracts = hex(0x2C8A1E),
          .repels = hex(0xB5179E),
          .wire_strength = 1.25f,
          .fade = 0.42f};
}

}  // namespace moltact
