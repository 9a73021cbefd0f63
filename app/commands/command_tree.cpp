#include "app/commands/command_tree.h"

#include <sstream>

namespace moltact {

std::vector<const CLI::App*> shownCommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<const CLI::Option*> shownOptions(const CLI::App& app, Wanted wanted) {
  return app.get_options([wanted](const CLI::Option* option) {
    return !option->get_group().empty() && option->get_positional() == (wanted == Wanted::Arguments);
  });
}

bool takesValue(const CLI::Option& option) { return option.get_type_size_max() > 0; }

// CLI11 stores the choices only in the type's name: "TEXT:{light,dark}".
std::vector<std::string> choicesOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t from = type.find('{'), to = type.rfind('}');
  std::vector<std::string> out;
  if (from == std::string::npos || to == std::string::npos || to < from) return out;
  std::istringstream words(type.substr(from + 1, to - from - 1));
  for (std::string word; std::getline(words, word, ',');) out.push_back(word);
  return out;
}

std::string fullName(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return (parent ? fullName(*parent) + ' ' : std::string()) + app.get_name();
}

const CLI::App& programOf(const CLI::App& app) { return app.get_parent() ? programOf(*app.get_parent()) : app; }

}  // namespace moltact
