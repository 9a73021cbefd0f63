#include "app/commands/molecule_argument.h"

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"

namespace moltact {

CLI::Option* MoleculeArgument::addTo(CLI::App& command) {
  CLI::Option* molecule =
      command
          .add_option("molecule", named.name,
                      "A file (" + moleculeEndingsText() + ", also .gz), or a molecule of the library (1ubq)")
          ->type_name(kMoleculeType)
          ->required();
  for (const ReadingOption& option : readingOptions()) {
    const std::string name = "--" + std::string(option.name), help(option.option_help);
    if (const auto* number = std::get_if<int ReadOptions::*>(&option.member))
      command.add_option(name, named.reading.**number, help)
          ->capture_default_str()
          ->check(CLI::Range(1, kMaxReadNumber));
    else if (const auto* on = std::get_if<bool ReadOptions::*>(&option.member))
      command.add_flag(name, named.reading.**on, help);
    else
      textOption(command, name, option);
  }
  return molecule;
}

void MoleculeArgument::textOption(CLI::App& command, const std::string& name, const ReadingOption& reading) {
  std::string help(reading.option_help);
  std::vector<std::string> words;
  if (reading.words)
    for (const OfferedWord& w : reading.words()) {
      words.emplace_back(w.name);
      help += "\n  " + words.back() + ": " + std::string(w.sentence);
    }
  CLI::Option* option = command.add_option_function<std::string>(
      name, [this, &reading](const std::string& text) { readText(named.reading, reading, text); }, help);
  if (reading.words) option->check(CLI::IsMember(words));
}

Molecule MoleculeArgument::load() const {
  auto molecule = openMolecule(named.name, named.reading);
  if (!molecule) throw CommandError{molecule.problem().text()};
  return *std::move(molecule);
}

}  // namespace moltact
