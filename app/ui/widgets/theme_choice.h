// The available themes and their names in files. Plain data; any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace moltact {

enum class ThemeChoice { Light, Dark, HighContrast };

inline constexpr std::array<std::string_view, 3> kThemeNames{"light", "dark", "high-contrast"};

inline std::string_view themeName(ThemeChoice theme) { return kThemeNames[std::size_t(theme)]; }

inline std::optional<ThemeChoice> themeNamed(std::string_view name) {
  const auto at = std::find(kThemeNames.begin(), kThemeNames.end(), name);
  if (at == kThemeNames.end()) return std::nullopt;
  return ThemeChoice(at - kThemeNames.begin());
}

}  // namespace moltact
