// The program's commands, options and arguments as --help shows them, for the manual page and the shell completion.
// Commands' thread.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace moltact {

/// The direct subcommands of `app`, in order, without hidden ones.
std::vector<const CLI::App*> shownCommands(const CLI::App& app);

/// The options ("--out") or the arguments ("molecule") of `app`, in order, without hidden ones.
enum class Wanted { Options, Arguments };
std::vector<const CLI::Option*> shownOptions(const CLI::App& app, Wanted wanted);

/// Whether the option takes a value. Flags take none.
bool takesValue(const CLI::Option& option);

/// The words that the option accepts, for example "light" and "dark" of --theme. Empty if it also accepts other values.
std::vector<std::string> choicesOf(const CLI::Option& option);

/// The command as typed in a shell: "moltact device check".
std::string fullName(const CLI::App& app);

/// The root of the tree that contains `app`, a command or a subcommand of a command.
const CLI::App& programOf(const CLI::App& app);

}  // namespace moltact
