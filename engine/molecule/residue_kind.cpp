#include "engine/molecule/residue_kind.h"

#include <gemmi/resinfo.hpp>

namespace moltact {
namespace {

bool hasAtom(const Residue& residue, const std::vector<Atom>& atoms, std::string_view name) {
  for (std::uint32_t i = residue.first_atom; i < residue.first_atom + residue.atom_count; ++i)
    if (name == atoms[i].name.data()) return true;
  return false;
}

bool isNobleGas(int z) { return z == 2 || z == 10 || z == 18 || z == 36 || z == 54 || z == 86; }

}  // namespace

bool isWaterName(std::string_view residue) {
  return gemmi::find_tabulated_residue(std::string(residue)).is_water() || residue == "TIP3" || residue == "SOL";
}

ResidueKind residueKind(const Residue& residue, const std::vector<Atom>& atoms, bool hetero) {
  if (isWaterName(residue.name)) return ResidueKind::Water;
  const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(residue.name.string());
  if (info.is_amino_acid()) return ResidueKind::AminoAcid;
  if (info.is_nucleic_acid()) return ResidueKind::Nucleotide;
  if (residue.atom_count == 1 && atoms[residue.first_atom].atomic_number > 1 &&
      !isNobleGas(atoms[residue.first_atom].atomic_number) && hetero)
    return ResidueKind::Ion;
  // A modified residue that the table lacks still has its backbone.
  if (hasAtom(residue, atoms, "N") && hasAtom(residue, atoms, "CA") && hasAtom(residue, atoms, "C") &&
      hasAtom(residue, atoms, "O"))
    return ResidueKind::AminoAcid;
  if (hasAtom(residue, atoms, "C1'") && hasAtom(residue, atoms, "C3'") && hasAtom(residue, atoms, "O3'") &&
      hasAtom(residue, atoms, "P"))
    return hetero ? ResidueKind::Ligand : ResidueKind::Nucleotide;
  return hetero || info.found() ? ResidueKind::Ligand : ResidueKind::Other;
}

}  // namespace moltact
