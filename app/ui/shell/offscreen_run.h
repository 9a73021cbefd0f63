// The application without a window, for pictures of itself and for measuring frames: `moltact --screenshot`.
#pragma once

#include <filesystem>

namespace moltact {

struct OffscreenOptions {
  std::filesystem::path file;        ///< opened at the start; empty: the welcome page
  std::filesystem::path screenshot;  ///< where the last frame goes; empty: nowhere
  std::filesystem::path script;      ///< acts before that, see scripted_user_steps.cpp; empty: none
  int width = 1280, height = 800;
  double content_scale = 1.0;
  bool frame_stats = false;        ///< tell the frame times on stdout
  std::string language;            ///< as in ApplicationOptions
  std::string device;              ///< as in ApplicationOptions
  std::string state_text;          ///< as in WindowOptions
  std::filesystem::path attempts;  ///< where what is done in a lesson is kept; empty: nowhere
};

/// Returns the program's exit status; errors are printed on stderr.
int runOffscreen(const OffscreenOptions& options);

}  // namespace moltact
