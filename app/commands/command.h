// The headless commands of `moltact`. Each command is one file in app/commands and one line in command.cpp.
#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// A command's callback throws this to end the command. The text is printed to stderr on one line.
struct CommandError {
  std::string text;
  int status = 1;  ///< the program's exit status
};

/// Ends a command with exit status 1 after it has printed its own error messages.
struct CommandFailed {};

/// Adds every command to `app` as a subcommand. Parsing runs the callback of the command that the user names.
void addAllCommands(CLI::App& app);

}  // namespace moltact
