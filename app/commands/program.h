// What every executable of the project does around its commands.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>

namespace moltact {

/// Runs the program's work and converts an exception of a command to a message and an exit status. Reports it if not all
/// of the output could be written. The body of main().
int runMain(const std::function<int()>& work);

/// Parses the command line, which runs the command. Returns the exit status to end with, after help or a message; nothing
/// if the line is valid.
std::optional<int> parsed(CLI::App& app, int argc, char** argv);

/// Gives a command what all have: the option for the language, and protection of its input files.
void completeCommand(CLI::App& command);

}  // namespace moltact
