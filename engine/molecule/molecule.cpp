#include "engine/molecule/molecule.h"

#include <cctype>

#include "engine/molecule/elements.h"

namespace moltact {

std::vector<Ball> Molecule::balls() const {
  std::vector<Ball> out;
  out.reserve(atoms.size());
  for (const Atom& atom : atoms) out.push_back({atom.position.A, atom.radius_A});
  return out;
}

std::string Molecule::describe(std::size_t index) const {
  const Atom& atom = atoms[index];
  if (atom.residue == kNoResidue) return "atom " + std::to_string(index);
  const Residue& residue = residues[atom.residue];
  const bool polymer = residue.kind == ResidueKind::AminoAcid || residue.kind == ResidueKind::Nucleotide;
  if (residue.atom_count == 1 && !polymer) {  // an ion or a noble gas: its element says more than two codes
    std::string name(element(atom.atomic_number).name);
    return (name.empty() ? residue.name.string() : name) + ' ' + std::to_string(residue.number);
  }
  std::string out = atom.name[0] ? std::string(atom.name.data()) : std::string(element(atom.atomic_number).symbol);
  out += " of ";
  std::string name = residue.name.string();
  // Amino acids are spoken of as Asp and Lys; other names are codes and keep their capitals.
  if (residue.kind == ResidueKind::AminoAcid)
    for (std::size_t i = 1; i < name.size(); ++i)
      name[i] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  out += name.empty() ? "residue" : name;
  out += ' ' + std::to_string(residue.number);
  if (residue.insertion != ' ') out += residue.insertion;
  const std::string_view chain = chains[residue.chain].name;
  if (!chain.empty()) out.append(" (chain ").append(chain) += ')';
  return out;
}

}  // namespace moltact
