// What the program was started with, for the window. Plain data.
#pragma once

#include <filesystem>
#include <string>

#include "app/ui/scene/haptic_session.h"

namespace moltact {

struct ApplicationOptions {
  ServoClock clock = ServoClock::RealThread;
  bool devices_unasked =
      true;  ///< where nobody chose a device, one that is plugged in is taken at the start and offered later
  std::string language{};  ///< at the start, in the place of the settings': "de"; empty: theirs
  std::string device{};    ///< leads at the start instead of the settings' one, which stays stored; empty: theirs
  std::filesystem::path settings_file{};    ///< empty: settings are neither read nor kept
  std::filesystem::path attempts_folder{};  ///< where attempts at lessons are kept; empty: nowhere
  std::filesystem::path packs_folder{};     ///< where lessons are put that come in a pack; empty: packsFolder()
  std::filesystem::path cache_folder{};     ///< for what can be made again; empty: nothing is kept
  std::filesystem::path picture_folder{};   ///< where "Save picture" puts pictures (default: the current folder)
};

}  // namespace moltact
