// The real window, on GLFW. Window's thread is the one that calls runWindow.
#pragma once

#include <filesystem>
#include <string>

namespace moltact {

struct WindowOptions {
  std::filesystem::path file;  ///< opened at the start; empty: the welcome page
  bool frame_stats = false;    ///< tell the frame times at the end
  std::string language;        ///< as in ApplicationOptions
  std::string device;          ///< as in ApplicationOptions
  std::string state_text;      ///< the state in words goes to this file, or to the terminal for "-"; empty: nowhere
};

/// Runs until the person leaves, or the system wants it to end (SIGINT, SIGTERM, SIGHUP), which is the same. Returns
/// the program's exit status; where there is no display, 1 and a message on stderr that names what can be done without
/// one.
int runWindow(const WindowOptions& options);

}  // namespace moltact
