// Residues and chains as atoms come, and the limits of a molecule.
#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/molecule/parsed_structure.h"
#include "engine/molecule/residue_kind.h"

namespace moltact {
namespace {

// Where the next one needs room: as much as the whole molecule will need if it goes on like this, so that nothing large
// is copied from a smaller room to a larger one, which would take both for a while.
template <class T>
void makeRoom(std::vector<T>& list, std::size_t atoms, std::size_t atoms_expected) {
  if (list.size() < list.capacity()) return;
  const double share = atoms ? double(list.size()) / double(atoms) : 0.0;
  const auto likely = static_cast<std::size_t>(1.05 * share * double(atoms_expected));
  list.reserve(std::max(list.size() + list.size() / 2 + 16, std::min(likely, kMaxMoleculeAtoms)));
}

// What a text takes besides its own object.
std::size_t heapBytes(std::string_view text) { return text.size() > std::string().capacity() ? text.size() + 1 : 0; }

}  // namespace

Problem tooManyAtoms(const std::string& file, std::size_t line) {
  return {file, line, 0, trf("more than {0} million atoms", kMaxMoleculeAtoms / 1'000'000),
          tr("split the file, or keep one model")};
}

void GrowingMolecule::expect(std::size_t atoms) { molecule.atoms.reserve(std::min(atoms, kMaxMoleculeAtoms)); }

std::optional<Problem> GrowingMolecule::full(const std::string& file, std::size_t line) const {
  const Molecule& m = molecule;
  if (m.atoms.size() >= kMaxMoleculeAtoms) return tooManyAtoms(file, line);
  const std::size_t bytes = m.atoms.size() * sizeof(Atom) +
                            m.residues.size() * (sizeof(Residue) + sizeof(std::uint32_t)) +
                            m.chains.size() * sizeof(Chain) + labels.size() * sizeof(std::string) + text_bytes_;
  if (bytes > kMaxMoleculeAtoms * kMoleculeBytesAnAtom)
    return Problem{file, line, 0, tr("its residues and chains take more than 3 GB of memory"),
                   tr("split the file, or keep one model")};
  return std::nullopt;
}

void GrowingMolecule::put(std::size_t at, const Atom& atom, const Place& place, bool hetero) {
  Molecule& m = molecule;
  const std::size_t expected = m.atoms.capacity();
  const bool same_chain = !m.chains.empty() && m.chains.back().name == place.chain;
  const bool same_label = !labels.empty() && labels.back() == place.label_chain;
  const bool same = same_chain && same_label && !m.residues.empty() && m.residues.back().number == place.number &&
                    m.residues.back().insertion == place.insertion && m.residues.back().name == place.residue;
  if (!same) {
    close();
    if (!same_chain) {
      makeRoom(m.chains, m.atoms.size(), expected);
      m.chains.push_back({std::string(place.chain), static_cast<std::uint32_t>(m.residues.size()), 0});
      text_bytes_ += heapBytes(place.chain);
    }
    if (!same_label) {
      makeRoom(labels, m.atoms.size(), expected);
      labels.emplace_back(place.label_chain);
      text_bytes_ += heapBytes(place.label_chain);
    }
    makeRoom(m.residues, m.atoms.size(), expected);
    Residue& residue = m.residues.emplace_back();
    residue.name = place.residue;
    text_bytes_ += heapBytes(place.residue);
    residue.number = place.number;
    residue.insertion = place.insertion;
    residue.chain = static_cast<std::uint32_t>(m.chains.size() - 1);
    residue.first_atom = static_cast<std::uint32_t>(at);
    ++m.chains.back().residue_count;
    makeRoom(label_of, m.atoms.size(), expected);
    label_of.push_back(static_cast<std::uint32_t>(labels.size() - 1));
    hetero_of.push_back(hetero);
  }
  if (at == m.atoms.size()) {
    makeRoom(m.atoms, m.atoms.size(), m.atoms.size());
    m.atoms.emplace_back();
  }
  m.atoms[at] = atom;
  m.atoms[at].residue = static_cast<std::uint32_t>(m.residues.size() - 1);
  ++m.residues.back().atom_count;
}

void GrowingMolecule::close() {
  if (molecule.residues.empty()) return;
  Residue& last = molecule.residues.back();
  last.kind = residueKind(last, molecule.atoms, hetero_of.back());
}

}  // namespace moltact
