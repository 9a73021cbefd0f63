// The settings of a person that the program keeps between two starts: theme, scale, panels, ways of showing and
// pointing. One JSON file in the user's configuration folder. Window's thread.
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

/// The figure drawn where the probe and the hand are: the probe as a water molecule or as a plain sphere, or a model at
/// the HIP too.
enum class ProbeLook { Water, Sphere, Stylus };

/// "water", "ball", "stylus".
std::string_view probeLookName(ProbeLook look);
std::optional<ProbeLook> probeLookNamed(std::string_view name);

struct Settings {
  ThemeChoice theme = ThemeChoice::Light;
  double scale = 1.0;              ///< times the monitor's own scale (0.75 to 3, default 1)
  double text_size = 1.0;          ///< letters, and what holds them, are so much larger than that (1 to 1.5, default 1)
  double lesson_width = 350.0;     ///< unit: pixel at 96 dpi (240 to 700)
  double touch_width = 288.0;      ///< unit: pixel at 96 dpi (220 to 600)
  bool depth_gauge = true;         ///< while touching, the view shows from the side how deep the hand is
  bool expert = false;             ///< figures of the touch loop and the tracker are shown
  bool legend = true;              ///< the colours of the atoms are named in the view
  bool colour_blind_safe = false;  ///< atoms in colours that every kind of colour vision tells apart
  bool left_handed = false;        ///< over the molecule the right button pushes and the left one turns
  std::string language;            ///< "de"; empty: the system's
  DecimalSign decimal_sign = DecimalSign::OfLanguage;  ///< of every number that is shown
  /// By the names of offeredDimensions(): "length" is shown in "nm"; one that is missing, in the program's own unit.
  std::map<std::string, std::string> units;
  std::string lesson_folder;        ///< where the person's own lessons are; empty: ownLessonsFolder()
  std::vector<std::string> recent;  ///< files opened last, newest first, at most kRecent
  static constexpr std::size_t kRecent = 8;

  std::string device;          ///< the one that was chosen last, by its name; empty: none was
  std::string device_address;  ///< the last device with an address, by its name: "open-tcp:127.0.0.1:7010"
  ProbeLook probe_look = ProbeLook::Water;
  bool sound = false;             ///< touch is heard
  bool sound_asked = false;       ///< the person has been asked whether it is to be
  double sound_volume = 0.4;      ///< of that sound (0 to 1): quiet at first
  bool reduced_motion = false;    ///< another scene is there at once: the camera does not glide, nothing fades
  bool large_state_text = false;  ///< what is touched, in large type over the view

  void remember(const std::filesystem::path& file);
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// The colours of the atoms that a person prefers.
inline ElementColours elementColoursOf(const Settings& s) {
  return s.colour_blind_safe ? ElementColours::ColourBlindSafe : ElementColours::Customary;
}

/// Settings and, where the file could not be used, why (one sentence; the defaults stand in for what is not sound).
struct LoadedSettings {
  Settings settings;
  std::string fault;
};

/// A missing file gives the defaults without fault.
LoadedSettings loadSettings(const std::filesystem::path& file);

/// Writes the file whole or not at all, making its folder. Only what differs from `before` (what this program has read
/// or written last) changes in a sound file that is there: what another window, or a newer version, has set in it
/// stays. Returns what went wrong, empty when nothing did.
std::string saveSettings(const Settings& settings, const std::filesystem::path& file,
                         const Settings& before = Settings());

}  // namespace moltact
