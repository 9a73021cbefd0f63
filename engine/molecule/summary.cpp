#include "engine/molecule/summary.h"

#include <algorithm>
#include <set>

#include "engine/molecule/elements.h"

namespace moltact {

MoleculeSummary summarise(const Molecule& molecule) {
  MoleculeSummary out;
  out.atoms = molecule.atoms.size();
  out.residues = molecule.residues.size();
  out.models = molecule.models_in_file;
  out.waters_left_out = molecule.waters_left_out;
  out.alternates_left_out = molecule.alternates_left_out;
  std::set<std::string> seen;
  for (const Chain& chain : molecule.chains)
    if (seen.insert(chain.name.string()).second) out.chain_names.push_back(chain.name.string());
  out.chains = out.chain_names.size();
  for (const Residue& residue : molecule.residues) {
    if (residue.kind == ResidueKind::Water) ++out.waters;
    if (residue.kind == ResidueKind::Ligand || residue.kind == ResidueKind::Ion) ++out.ligands[residue.name.string()];
  }
  std::array<std::size_t, kElementCount + 1> count{};
  for (const Atom& atom : molecule.atoms) ++count[std::min<std::size_t>(atom.atomic_number, kElementCount)];
  for (int z = 0; z <= kElementCount; ++z)
    if (count[static_cast<std::size_t>(z)])
      out.elements[std::string(element(z).symbol)] = count[static_cast<std::size_t>(z)];
  if (!molecule.atoms.empty()) out.low_A = out.high_A = molecule.spheres.front().centre_A;
  for (const Sphere& atom : molecule.spheres) {
    out.low_A = glm::min(out.low_A, atom.centre_A);
    out.high_A = glm::max(out.high_A, atom.centre_A);
  }
  return out;
}

}  // namespace moltact
