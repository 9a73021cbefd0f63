#include "app/commands/molecule_argument.h"

#include "app/commands/command.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"

namespace moltact {

void MoleculeArgument::addTo(CLI::App& command) {
  command
      .add_option("molecule", named.name,
                  "A file (" + moleculeEndingsText() + ", also .gz), or a molecule of the library (1ubq)")
      ->required();
  command.add_option("--model", named.reading.model, "Which model of the file, from 1")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command.add_flag("--waters", named.reading.waters, "Keep the water molecules");
  command.add_option("--assembly", named.reading.assembly, "Build this biological assembly (1)");
}

Molecule MoleculeArgument::load() const {
  auto molecule = openMolecule(named.name, named.reading);
  if (!molecule) throw CommandError{molecule.problem().text()};
  return *std::move(molecule);
}

}  // namespace moltact
