// What the program remembers of a person between two starts: theme, scale, panels. One JSON file in the user's
// configuration folder. Window's thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moltact {

enum class ThemeChoice { Light, Dark };

struct Settings {
  ThemeChoice theme = ThemeChoice::Light;
  double scale = 1.0;             ///< times the monitor's own scale (0.75 to 3, default 1)
  double lesson_width = 350.0;    ///< unit: pixel at 96 dpi (240 to 700)
  double touch_width = 288.0;     ///< unit: pixel at 96 dpi (220 to 600)
  std::vector<std::string> recent;  ///< files opened last, newest first, at most kRecent
  static constexpr std::size_t kRecent = 8;

  void remember(const std::filesystem::path& file);
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// Settings and, where the file could not be used, why (one sentence; the defaults stand in for what is not sound).
struct LoadedSettings {
  Settings settings;
  std::string trouble;
};

/// A missing file gives the defaults without trouble.
LoadedSettings loadSettings(const std::filesystem::path& file);

/// Writes the file whole or not at all, making its folder. Returns what went wrong, empty when nothing did.
std::string saveSettings(const Settings& settings, const std::filesystem::path& file);

}  // namespace moltact
