#include "engine/molecule/molecule.h"

#include <cctype>

#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/residue_names.h"

namespace moltact {

std::vector<Ball> Molecule::balls() const {
  std::vector<Ball> out;
  out.reserve(atoms.size());
  for (const Atom& atom : atoms) out.push_back({atom.position.A, atom.radius_A});
  return out;
}

std::string Molecule::describe(std::size_t index) const {
  const AtomWords w = words(index);
  if (w.residue.empty()) return w.atom;
  return w.chain.empty() ? trcf("an atom", "{0} of {1}", w.atom, w.residue)
                         : trf("{0} of {1} (chain {2})", w.atom, w.residue, w.chain);
}

AtomWords Molecule::words(std::size_t index) const {
  const Atom& atom = atoms[index];
  if (atom.residue == kNoResidue) return {trf("atom {0}", index), {}, {}};
  const Residue& residue = residues[atom.residue];
  const bool polymer = residue.kind == ResidueKind::AminoAcid || residue.kind == ResidueKind::Nucleotide;
  if (residue.atom_count == 1 && !polymer) {  // an ion or a noble gas: its element says more than two codes
    const std::string name(tr(element(atom.atomic_number).name));
    return {(name.empty() ? residue.name.string() : name) + ' ' + std::to_string(residue.number), {}, {}};
  }
  AtomWords out;
  out.atom = atom.name[0] ? std::string(atom.name.data()) : std::string(element(atom.atomic_number).symbol);
  std::string name = residue.name.string();
  // Amino acids are spoken of as Asp and Lys; of other codes those that nobody knows by heart are said in words, and what
  // has none keeps its capitals.
  const bool may_be_base = name.size() > 1 || residue.kind == ResidueKind::Nucleotide;
  if (const std::string plain = plainResidueName(name); may_be_base && !plain.empty())
    name = plain;
  else if (residue.kind == ResidueKind::AminoAcid)
    for (std::size_t i = 1; i < name.size(); ++i)
      name[i] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  out.residue =
      (name.empty() ? std::string(trc("of an atom", "residue")) : name) + ' ' + std::to_string(residue.number);
  if (residue.insertion != ' ') out.residue += residue.insertion;
  out.chain = chains[residue.chain].name.string();
  return out;
}

}  // namespace moltact
