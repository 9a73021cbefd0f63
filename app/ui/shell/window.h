// The desktop window, on GLFW. Window's thread is the thread that calls runWindow.
#pragma once

#include <filesystem>
#include <string>

namespace moltact {

struct WindowOptions {
  std::filesystem::path file;  ///< opened at the start; empty: the welcome page
  bool frame_stats = false;    ///< print the frame times at the end
  std::string language;        ///< as in ApplicationOptions
  std::string device;          ///< as in ApplicationOptions
  std::string simulation;      ///< as in ApplicationOptions
  std::string state_text;      ///< output of the state in words: a file, or the terminal for "-"; empty: none
};

/// Runs until the user quits or the system ends the program (SIGINT, SIGTERM, SIGHUP). Returns the program's exit
/// status. Without a display it returns 1 and prints to stderr which commands work without one.
int runWindow(const WindowOptions& options);

}  // namespace moltact
