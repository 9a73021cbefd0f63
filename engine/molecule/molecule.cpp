#include "engine/molecule/molecule.h"

#include <cassert>
#include <cctype>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/residue_names.h"

namespace moltact {

PlacedAtom Molecule::at(std::size_t atom) const {
  return {{atoms[atom]}, {spheres[atom].centre_A}, spheres[atom].radius_A};
}

std::vector<PlacedAtom> Molecule::placedAtoms() const {
  std::vector<PlacedAtom> out;
  out.reserve(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i) out.push_back(at(i));
  return out;
}

void Molecule::setAtoms(const std::vector<PlacedAtom>& placed) {
  std::vector<Atom> kinds(placed.begin(), placed.end());
  std::vector<Sphere> places;
  places.reserve(placed.size());
  for (const PlacedAtom& atom : placed) places.push_back(atom.sphere());
  atoms = std::move(kinds);
  spheres = std::move(places);
  spheres_as_read = {};
}

Molecule Molecule::movedTo(SharedArray<Sphere> coordinates) const {
  assert(coordinates.size() == atoms.size());
  Molecule out = *this;
  out.spheres_as_read = spheresAsRead();
  out.spheres = std::move(coordinates);
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
  if (residue.atom_count == 1 && !polymer) {  // an ion or a noble gas: its element says more than the codes
    const std::string name(tr(element(atom.atomic_number).name));
    return {(name.empty() ? residue.name.string() : name) + ' ' + std::to_string(residue.number), {}, {}};
  }
  AtomWords out;
  out.atom = atom.name[0] ? std::string(atom.name.data()) : std::string(element(atom.atomic_number).symbol);
  std::string name = residue.name.string();
  // Amino acids are named Asp, Lys etc. Codes that few people know are replaced by plain names, and codes without a
  // plain name keep their capitals.
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
