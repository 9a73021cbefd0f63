#include "app/commands/molecule_argument.h"

#include "app/commands/command.h"
#include "engine/molecule/reader.h"

namespace moltact {

std::shared_ptr<const Molecule> moleculeArgument(const std::string& argument) {
  auto molecule = readMolecule(argument);
  if (!molecule) throw CommandError{molecule.problem().text()};
  return std::make_shared<const Molecule>(*std::move(molecule));
}

}  // namespace moltact
