#include "engine/molecule/molecule_storage.h"

#include <algorithm>
#include <numeric>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/molecule/residue_kind.h"

namespace moltact {
namespace {

// Grows a list to the estimated size of the whole molecule, so that nothing large is copied to a larger allocation,
// which would hold both for a while.
template <class T>
void makeRoom(std::vector<T>& list, std::size_t atoms, std::size_t atoms_expected) {
  if (list.size() < list.capacity()) return;
  const double share = atoms ? double(list.size()) / double(atoms) : 0.0;
  const auto likely = static_cast<std::size_t>(1.02 * share * double(atoms_expected));
  list.reserve(std::max(list.size() + list.size() / 2 + 16, std::min(likely, kMaxMoleculeAtoms)));
}

// The heap memory of a text, including the overhead of an allocation.
std::size_t heapBytes(std::string_view text) { return text.size() > ShortText::kInside ? text.size() + 16 : 0; }

// Residues whose atoms are apart in the file, such as by waters between them, are joined if fewer than so many other
// label chains lie between.
constexpr std::size_t kLastLabels = 16;

}  // namespace

Problem tooManyAtoms(const std::string& file, std::size_t line) {
  return {file, line, 0, trf("more than {0} million atoms", kMaxMoleculeAtoms / 1'000'000),
          tr("split the file, or keep one model")};
}

void MoleculeStorage::expect(std::size_t atoms) {
  const std::size_t room = std::min(atoms, kMaxMoleculeAtoms);
  arrays.atoms.reserve(room);
  arrays.spheres.reserve(room);
  if (has_charges_) arrays.charges_e.reserve(room);
}

std::optional<Problem> MoleculeStorage::full(const std::string& file, std::size_t line) const {
  if (arrays.atoms.size() >= kMaxMoleculeAtoms) return tooManyAtoms(file, line);
  if (bytes() > kMaxMoleculeAtoms * kMoleculeBytesAnAtom)
    return Problem{file, line, 0, tr("its residues and chains take more than 3 GB of memory"),
                   tr("split the file, or keep one model")};
  return std::nullopt;
}

std::size_t MoleculeStorage::bytes() const {
  const MoleculeArrays& m = arrays;
  return m.atoms.size() * (sizeof(Atom) + sizeof(Sphere)) + m.charges_e.size() * sizeof(float) +
         m.residues.size() * sizeof(Residue) + m.chains.size() * sizeof(Chain) +
         (label_of_.size() + m.numbers_in_file.size()) * sizeof(std::uint32_t) + labels_.size() * sizeof(ShortText) +
         hetero_of.size() / 8 + text_bytes_;
}

std::string_view MoleculeStorage::labelChain(std::size_t residue) const {
  if (label_of_.empty() || label_of_[residue] == 0) return {};
  if (names_label_chains_) return labels_[label_of_[residue] - 1];
  return {reinterpret_cast<const char*>(&label_of_[residue]), sizeof(std::uint32_t)};
}

void MoleculeStorage::put(std::size_t at, const PlacedAtom& atom, float charge_e, const Place& place, bool hetero) {
  MoleculeArrays& m = arrays;
  const std::size_t expected = m.atoms.capacity();
  const bool same_chain = !m.chains.empty() && m.chains.back().name == place.chain;
  const bool same_label = label_chain_ == place.label_chain;
  const bool same = same_chain && same_label && !m.residues.empty() && m.residues.back().number == place.number &&
                    m.residues.back().insertion == place.insertion && m.residues.back().name == place.residue;
  if (!same) {
    close();
    if (!same_chain) {
      makeRoom(m.chains, m.atoms.size(), expected);
      m.chains.push_back({place.chain, static_cast<std::uint32_t>(m.residues.size()), 0});
      text_bytes_ += heapBytes(place.chain);
    }
    if (!same_label) {
      label_chain_ = place.label_chain;
      if (names_label_chains_ && !label_chain_.empty()) {
        makeRoom(labels_, m.atoms.size(), expected);
        labels_.emplace_back(label_chain_);
        text_bytes_ += heapBytes(label_chain_);
      }
      if (label_of_.empty()) label_of_.resize(m.residues.size());
    }
    if (!label_of_.empty() || !label_chain_.empty()) {
      makeRoom(label_of_, m.atoms.size(), expected);
      std::uint32_t number = static_cast<std::uint32_t>(labels_.size());
      if (!names_label_chains_ && !label_chain_.empty()) {
        auto known = std::find_if(last_labels_.begin(), last_labels_.end(),
                                  [&](const auto& label) { return label.first == label_chain_; });
        if (known == last_labels_.end()) {
          if (last_labels_.size() == kLastLabels) last_labels_.pop_back();
          known = last_labels_.insert(last_labels_.begin(), {label_chain_, ++label_count_});
        }
        number = known->second;
      }
      label_of_.push_back(label_chain_.empty() ? 0 : number);
    }
    makeRoom(m.residues, m.atoms.size(), expected);
    Residue& residue = m.residues.emplace_back();
    residue.name = place.residue;
    text_bytes_ += heapBytes(place.residue);
    residue.number = place.number;
    residue.insertion = place.insertion;
    residue.recorded = place.recorded;
    residue.chain = static_cast<std::uint32_t>(m.chains.size() - 1);
    residue.first_atom = static_cast<std::uint32_t>(at);
    ++m.chains.back().residue_count;
    hetero_of.push_back(hetero);
  }
  if (at == m.atoms.size()) {
    makeRoom(m.atoms, m.atoms.size(), m.atoms.size());
    makeRoom(m.spheres, m.atoms.size(), m.atoms.size());
    m.atoms.emplace_back();
    m.spheres.emplace_back();
    if (has_charges_) m.charges_e.emplace_back();
  }
  m.atoms[at] = atom;
  m.spheres[at] = atom.sphere();
  if (has_charges_) m.charges_e[at] = charge_e;
  m.atoms[at].residue = static_cast<std::uint32_t>(m.residues.size() - 1);
  ++m.residues.back().atom_count;
}

void MoleculeStorage::setNumberInFile(std::size_t at, std::uint32_t number) {
  std::vector<std::uint32_t>& numbers = arrays.numbers_in_file;
  if (numbers.empty()) {
    if (number == at) return;
    // All atoms before this one have their own index.
    numbers.reserve(arrays.atoms.capacity());
    numbers.resize(at);
    std::iota(numbers.begin(), numbers.end(), 0u);
  }
  if (at == numbers.size())
    numbers.push_back(number);
  else
    numbers[at] = number;
}

void MoleculeStorage::close() {
  if (arrays.residues.empty()) return;
  Residue& last = arrays.residues.back();
  last.kind = residueKind(last, arrays.atoms, hetero_of.back());
}

}  // namespace moltact
