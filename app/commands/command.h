// A headless command of `moltact`. Each is one file in app/commands and one line in command.cpp.
#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// Adds the command's own subcommand to `app`; its callback runs it. A callback that fails throws CommandError.
using AddCommand = void (*)(CLI::App& app);

/// What ends a command with exit status 1: its text goes to stderr.
struct CommandError {
  std::string text;
};

void addAllCommands(CLI::App& app);

void addRenderCommand(CLI::App& app);

}  // namespace moltact
