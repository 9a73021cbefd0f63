#include "engine/structure/secondary_structure.h"

namespace moltact {
namespace {

MoleculeStructure recordedStructure(const Molecule& m) {
  MoleculeStructure out;
  out.source = MoleculeStructure::Source::File;
  out.of_residue.resize(m.residues.size(), SecondaryStructure::Coil);
  RecordedStructure before;
  for (std::uint32_t r = 0; r < m.residues.size(); ++r) {
    const RecordedStructure now = m.residues[r].recorded;
    out.of_residue[r] = now.kind;
    const bool continued = r > 0 && !now.begins && before.kind == now.kind && before.helix == now.helix &&
                           m.residues[r].chain == m.residues[r - 1].chain;
    if (now.kind != SecondaryStructure::Coil) {
      if (continued)
        out.elements.back().last_residue = r;
      else
        out.elements.push_back({now.kind, now.helix, r, r});
    }
    before = now;
  }
  return out;
}

}  // namespace

MoleculeStructure secondaryStructure(const Molecule& molecule) {
  return molecule.has_recorded_structure ? recordedStructure(molecule) : structureByHydrogenBonds(molecule);
}

}  // namespace moltact
