// The program's commands, options and arguments as --help shows them, for what is made from them: the manual page and
// the completion in a shell. Commands' thread.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace moltact {

/// The commands of `app` itself, in order; not the hidden ones.
std::vector<const CLI::App*> shownCommands(const CLI::App& app);

/// Its options ("--out"), or its arguments ("molecule"), in order; not the hidden ones.
enum class Wanted { Options, Arguments };
std::vector<const CLI::Option*> shownOptions(const CLI::App& app, Wanted wanted);

/// Whether a value follows it; flags have none.
bool takesValue(const CLI::Option& option);

/// The words of which it takes one: "light" and "dark" of --theme. Empty where others are allowed.
std::vector<std::string> choicesOf(const CLI::Option& option);

/// As a shell knows it: "moltact device check".
std::string fullName(const CLI::App& app);

/// The program, of which `app` is a command or a command's command.
const CLI::App& programOf(const CLI::App& app);

}  // namespace moltact
