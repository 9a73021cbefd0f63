#include "app/commands/atoms_option.h"

#include "engine/haptics/body/held_body.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/lesson/selection.h"

namespace moltact {

std::vector<std::uint32_t> selectedAtoms(const char* option, const std::string& text, const Molecule& molecule) {
  if (text.empty()) return {};
  const Expected<Selection> atoms = parseSelection(text);
  if (!atoms) throw CLI::ValidationError(option, atoms.problem().text());
  std::vector<std::uint32_t> selected = atoms->select(molecule);
  if (selected.empty()) throw CLI::ValidationError(option, atoms->whyEmpty(molecule).text());
  return selected;
}

CLI::ValidationError tooManyHeld(std::size_t atoms) {
  return CLI::ValidationError(
      "--in-hand", "it holds " + std::to_string(atoms) + " atoms; the most are " + std::to_string(kMaxHeldAtoms));
}

void ExcludedAtoms::addTo(CLI::App& command) {
  command.add_option("--untouchable", untouchable,
                     "Selection of atoms that are not felt: 'ligand'; the probe passes through them");
  command.add_option("--remove", remove, "Selection of atoms that are removed: neither felt nor drawn");
}

std::vector<std::uint32_t> ExcludedAtoms::notFelt(const Molecule& molecule) const {
  return atomsOfEither(selectedAtoms("--untouchable", untouchable, molecule), removed(molecule));
}

}  // namespace moltact
