// The arguments of `moltact` without a command: what to open, and hidden ones for pictures and measurements.
#pragma once

#include <CLI/CLI.hpp>

#include "app/ui/shell/offscreen_run.h"
#include "app/ui/shell/window.h"

namespace moltact {

struct WindowArguments {
  std::string file, language, device, simulation, state_text, screenshot, script, size, attempts;
  double scale = 1.0;
  bool frame_stats = false;
};

/// Adds a command for each engine in another program, such as `moltact imd HOST:PORT MOLECULE`, which opens the window too.
/// `into` must outlive the parsing.
void addSimulations(CLI::App& app, WindowArguments& into);

/// Whether the parsed command line opens the window: without a command, or with one of addSimulations().
bool opensWindow(const CLI::App& app);

/// Adds the arguments; `into` must outlive the parsing.
void addWindowArguments(CLI::App& app, WindowArguments& into);

/// Opens the window, or draws off-screen where that was asked for. Returns the exit status.
int runWindowArguments(const WindowArguments& arguments);

}  // namespace moltact
