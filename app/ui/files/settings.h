// The user's settings, which the program keeps between runs: theme, scale, panels, display and pointing. Stored as one
// JSON file in the user's configuration folder. Window's thread.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/widgets/theme_choice.h"
#include "engine/language/quantity_text.h"
#include "engine/render/atom_style.h"

namespace moltact {

/// The model drawn at the probe and the hand: the probe as a water molecule or as a plain sphere, or additionally a
/// stylus at the HIP.
enum class ProbeLook { Water, Sphere, Stylus };

/// "water", "ball", "stylus".
std::string_view probeLookName(ProbeLook look);
std::optional<ProbeLook> probeLookNamed(std::string_view name);

struct Settings {
  ThemeChoice theme = ThemeChoice::Light;
  double scale = 1.0;              ///< multiplies the monitor's own scale (0.75 to 3)
  double text_size = 1.0;          ///< enlarges text, and the controls that hold it, beyond `scale` (1 to 1.5)
  double lesson_width = 350.0;     ///< unit: pixel at 96 dpi (240 to 700)
  double touch_width = 288.0;      ///< unit: pixel at 96 dpi (220 to 600)
  bool depth_gauge = true;         ///< show the depth of the hand from the side, and the energy between atoms
  bool expert = false;             ///< show figures of the servo loop and the tracker
  bool legend = true;              ///< show the legend of the atoms' colours in the view
  bool colour_blind_safe = false;  ///< use atom colours that are distinguishable with every kind of colour vision
  bool left_handed = false;        ///< over the molecule, the right button pushes and the left one rotates
  std::string language;            ///< "de"; empty: the system's language
  DecimalSign decimal_sign = DecimalSign::OfLanguage;  ///< of every number on the screen
  /// Maps names of offeredDimensions() to units: "length" to "nm". A dimension that is missing uses the program's own
  /// unit.
  std::map<std::string, std::string> units;
  std::string lesson_folder;        ///< the folder of the user's own lessons; empty: ownLessonsFolder()
  std::vector<std::string> recent;  ///< files opened last, newest first, at most kRecent
  static constexpr std::size_t kRecent = 8;

  std::string device;          ///< the name of the device chosen last; empty: none
  std::string device_address;  ///< the name of the last device with an address: "open-tcp:127.0.0.1:7010"
  ProbeLook probe_look = ProbeLook::Water;
  bool sound = false;             ///< play the sound of touch
  bool sound_asked = false;       ///< the user has been asked about sound
  double sound_volume = 0.4;      ///< volume of that sound (0 to 1); quiet by default
  bool reduced_motion = false;    ///< change scenes at once, without camera motion and fading
  bool large_state_text = false;  ///< show the contact in words, in large type over the view

  void remember(const std::filesystem::path& file);
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// The atom colours that the user prefers.
inline ElementColours elementColoursOf(const Settings& s) {
  return s.colour_blind_safe ? ElementColours::ColourBlindSafe : ElementColours::Customary;
}

/// The settings and, if the file could not be used, one sentence with the reason. Defaults replace invalid values.
struct LoadedSettings {
  Settings settings;
  std::string fault;
};

/// A missing file gives the defaults without a fault.
LoadedSettings loadSettings(const std::filesystem::path& file);

/// Writes the file atomically and creates its folder. In a valid existing file, only values that differ from `before`
/// (last read or written by this program) are changed. Values set by another window or a newer version stay. Returns an
/// error message, empty on success.
std::string saveSettings(const Settings& settings, const std::filesystem::path& file,
                         const Settings& before = Settings());

}  // namespace moltact
