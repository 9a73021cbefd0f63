// A headless command of `moltact`. Each is one file in app/commands and one line in command.cpp.
#pragma once

#include <CLI/CLI.hpp>

namespace moltact {

/// A command's callback throws this to end the command: the text goes to stderr, on one line.
struct CommandError {
  std::string text;
  int status = 1;  ///< the program's exit status
};

/// Ends a command with exit status 1 where it has already printed what is wrong.
struct CommandFailed {};

/// Adds every command as a subcommand of `app`; the callback of the one that is named runs it.
void addAllCommands(CLI::App& app);

}  // namespace moltact
