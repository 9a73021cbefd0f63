// Runs the application without a window, for screenshots and for measuring frame times: `moltact --screenshot`.
#pragma once

#include <filesystem>

namespace moltact {

struct OffscreenOptions {
  std::filesystem::path file;        ///< opened at the start; empty: the welcome page
  std::filesystem::path screenshot;  ///< output file of the last frame; empty: none
  std::filesystem::path script;      ///< script that runs before it, see scripted_user_steps.cpp; empty: none
  int width = 1280, height = 800;
  double content_scale = 1.0;
  bool frame_stats = false;        ///< print the frame times to stdout
  std::string language;            ///< as in ApplicationOptions
  std::string device;              ///< as in ApplicationOptions
  std::string simulation;          ///< as in ApplicationOptions
  std::string state_text;          ///< as in WindowOptions
  std::filesystem::path attempts;  ///< folder for the attempts at lessons; empty: attempts are not kept
};

/// Returns the program's exit status. Errors are printed to stderr.
int runOffscreen(const OffscreenOptions& options);

}  // namespace moltact
