// The storage of a molecule under construction, within the limits of a molecule's atoms and memory. Internal to
// engine/molecule. Units: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/text.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// The arrays of a molecule under construction.
struct MoleculeArrays {
  std::vector<Atom> atoms;
  std::vector<Sphere> spheres;   ///< one per atom
  std::vector<float> charges_e;  ///< one per atom; empty: the format has no charges
  /// Molecule::numbers_in_file; empty while they are 0, 1, 2, …
  std::vector<std::uint32_t> numbers_in_file;
  std::vector<Residue> residues;
  std::vector<Chain> chains;
};

/// A molecule under construction, which only appends and counts: MoleculeBuilder applies the rules of a file to it, and an
/// assembly copies from one to another. Residues and chains are contiguous ranges of atoms, in the order of arrival.
class MoleculeStorage {
 public:
  /// The residue and chains of an atom; texts as in ParsedAtom.
  struct Place {
    std::string_view residue, chain, label_chain;
    int number = 0;
    char insertion = ' ';
    RecordedStructure recorded{};
  };
  /// `names_label_chains`: keeps the names of label chains for a later assembly; otherwise only their identity is kept.
  /// `has_charges`: the atoms have partial charges.
  explicit MoleculeStorage(bool names_label_chains = false, bool has_charges = false)
      : names_label_chains_(names_label_chains), has_charges_(has_charges) {}
  /// Reserves memory for about this number of atoms.
  void expect(std::size_t atoms);
  /// The number in the file of an atom. `atom` must be in range.
  std::uint32_t numberInFile(std::size_t atom) const {
    return arrays.numbers_in_file.empty() ? static_cast<std::uint32_t>(atom) : arrays.numbers_in_file[atom];
  }
  /// Sets that of the atom at index `at`, which is the last or has been overwritten.
  void setNumberInFile(std::size_t at, std::uint32_t number);
  /// Appends an atom; consecutive atoms of the same residue and chain are grouped.
  void add(const PlacedAtom& atom, float charge_e, const Place& place, bool hetero) {
    put(arrays.atoms.size(), atom, charge_e, place, hetero);
  }
  /// The same, but overwrites the atom at index `at`. Calls must be in ascending order.
  void put(std::size_t at, const PlacedAtom& atom, float charge_e, const Place& place, bool hetero);
  /// An atom and its charge (0 without charges). `atom` must be in range.
  PlacedAtom at(std::size_t atom) const {
    return {{arrays.atoms[atom]}, {arrays.spheres[atom].centre_A}, arrays.spheres[atom].radius_A};
  }
  float charge_e(std::size_t atom) const { return has_charges_ ? arrays.charges_e[atom] : 0.0f; }
  /// Returns a Problem if another atom would exceed the limit of atoms or of a molecule's memory.
  std::optional<Problem> full(const std::string& file, std::size_t line) const;
  /// The memory in use (unit: byte).
  std::size_t bytes() const;
  /// Completes the last residue.
  void close();
  /// The label_chain of a residue; without names, a text that identifies it.
  std::string_view labelChain(std::size_t residue) const;
  bool namesLabelChains() const { return names_label_chains_; }
  bool hasCharges() const { return has_charges_; }

  MoleculeArrays arrays;
  std::vector<bool> hetero_of;  ///< per residue: HETATM

 private:
  bool names_label_chains_, has_charges_;
  std::string label_chain_;  // of the last residue
  // Per residue: index into labels_ from 1, or without names the label's number; 0: none. Empty if no residue has one.
  std::vector<std::uint32_t> label_of_;
  // Without names: the last labels with their numbers, the newest in front. A label that comes back after many others
  // gets another number; equal numbers always mean equal labels.
  std::vector<std::pair<std::string, std::uint32_t>> last_labels_;
  std::uint32_t label_count_ = 0;  // numbers given so far
  std::vector<ShortText> labels_;  // one for each run of equal labels
  std::size_t text_bytes_ = 0;     // of names too long for a ShortText's own storage
};

/// The Problem "more than 25 million atoms".
Problem tooManyAtoms(const std::string& file, std::size_t line);

}  // namespace moltact
