// The options with which the window is started. Plain data.
#pragma once

#include <filesystem>
#include <string>

#include "app/ui/scene/haptic_session.h"

namespace moltact {

struct ApplicationOptions {
  ServoClock clock = ServoClock::RealThread;
  bool devices_unasked =
      /// If no device was ever chosen: uses one that is connected at the start, and offers one that is connected later.
      true;
  std::string language{};    ///< used instead of the setting: "de"; empty: the setting
  std::string device{};      ///< used instead of the setting, which remains stored; empty: the setting
  std::string simulation{};  ///< its address, if one moves the first molecule: "imd://127.0.0.1:8888"; empty: none
  std::filesystem::path settings_file{};    ///< empty: settings are neither read nor stored
  std::filesystem::path attempts_folder{};  ///< folder of the attempts; empty: none are stored
  std::filesystem::path packs_folder{};     ///< folder for lessons from packs; empty: packsFolder()
  std::filesystem::path cache_folder{};     ///< for data that can be recomputed; empty: nothing is stored
  std::filesystem::path picture_folder{};   ///< folder for "Save picture" (default: the current folder)
};

}  // namespace moltact
