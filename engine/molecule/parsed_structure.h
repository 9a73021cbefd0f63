// The parsed atoms that a format's reader passes on one by one, and the builder that assembles them into a molecule by
// the rules of reader.h. Only the molecule itself grows with the file. Internal to engine/molecule. Units: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/text.h"
#include "engine/molecule/reader.h"
#include "engine/molecule/text_source.h"

namespace moltact {

/// One atom of the file. The texts need to be valid only during the call that receives them.
struct ParsedAtom {
  std::string_view name;         ///< "CA"
  std::string_view residue;      ///< "ALA"
  std::string_view chain;        ///< "A", the author's name (auth_asym_id)
  std::string_view label_chain;  ///< mmCIF's label_asym_id; empty in other formats
  std::string_view element;      ///< symbol in the file; used if atomic_number is 0
  Vec3 position_A{0.0};
  double occupancy = 1.0;
  double b_factor_A2 = 0.0;
  double radius_A = -1.0;  ///< radius in the file; negative: use that of the element
  double charge_e = 0.0;   ///< partial charge, for formats with charges
  std::size_t line = 0;    ///< line in the file, from 1; 0: unknown
  int number = 0;          ///< residue number
  int atomic_number = 0;
  char insertion = ' ';
  char alternate = ' ';  ///< alternate location; a space: none
  bool hetero = false;   ///< HETATM
};

/// A rotation followed by a translation that copies a part of the molecule into its biological assembly.
struct ParsedOperator {
  glm::dmat3 rotation{1.0};
  Vec3 shift_A{0.0};
};

struct ParsedAssembly {
  struct Part {
    std::vector<std::string> chains;        ///< ParsedAtom::chain (PDB)
    std::vector<std::string> label_chains;  ///< ParsedAtom::label_chain (mmCIF)
    std::vector<ParsedOperator> operators;
  };
  std::string name;
  std::vector<Part> parts;
};

/// A helix or strand recorded in a file: a range of residues of a chain, both ends included.
struct ParsedSecondaryStructure {
  struct End {
    int number = 0;
    char insertion = ' ';
  };
  RecordedStructure structure;
  std::string chain;
  End first, last;
};

/// The contents of a file other than its atoms.
struct ParsedHeader {
  std::string id, title;
  std::vector<ParsedSecondaryStructure> elements;  ///< helices and strands
  std::vector<ParsedAssembly> assemblies;
  std::vector<std::string> warnings;
  int models = 1;  ///< in the file
};

/// The arrays of a molecule under construction.
struct MoleculeArrays {
  std::vector<Atom> atoms;
  std::vector<Sphere> spheres;   ///< one per atom
  std::vector<float> charges_e;  ///< one per atom; empty: the format has no charges
  std::vector<Residue> residues;
  std::vector<Chain> chains;
};

/// A molecule under construction. Residues and chains are contiguous ranges of atoms, in the order of arrival.
class GrowingMolecule {
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
  explicit GrowingMolecule(bool names_label_chains = false, bool has_charges = false)
      : names_label_chains_(names_label_chains), has_charges_(has_charges) {}
  /// Reserves memory for about this number of atoms.
  void expect(std::size_t atoms);
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
  // Per residue: index into labels_ from 1, or without names a hash; 0: none. Empty if no residue has one.
  std::vector<std::uint32_t> label_of_;
  std::vector<ShortText> labels_;  // one for each run of equal labels
  std::size_t text_bytes_ = 0;     // of names too long for a ShortText's own storage
};

/// Receives the atoms of one model and applies the rules of reader.h.
class MoleculeBuilder {
 public:
  /// `text` must outlive the builder; it provides the file's name and, by its length, an estimate of the number of
  /// atoms. `has_charges`: the format has a partial charge for each atom.
  MoleculeBuilder(const TextSource& text, const ReadOptions& options, bool has_charges = false);
  std::optional<Problem> add(const ParsedAtom& atom);
  Expected<Molecule> finish(ParsedHeader head);

 private:
  // An atom with the data needed until its residue is complete.
  struct Waiting {
    PlacedAtom atom;
    float charge_e = 0.0f;
    std::uint64_t name = 0;  // hash of the full name
    double occupancy = 1.0;
    std::uint32_t residue = 0;  // index into residues_
    std::int32_t unknown = -1;  // index into unknown_ if the radius is unknown
    char alternate = ' ';
    bool hetero = false;
  };
  void expectMore();
  void endPlace();
  void dropAlternates();
  void keepLikeliest();
  std::int32_t unknownElement(const ParsedAtom& atom);
  void warnOfElements(bool waters_kept, std::vector<std::string>& warnings) const;

  const ReadOptions& options_;
  const TextSource& text_;
  std::string file_;
  GrowingMolecule out_;
  std::size_t atoms_ = 0, before_ = 0;  // number of atoms so far; bytes of text before the first
  // The position in the chain of the last atoms: one residue, or several alternative ones.
  std::string chain_, label_chain_;
  int number_ = 0;
  char insertion_ = ' ';
  std::vector<std::string> residues_;  // their names
  std::vector<Waiting> waiting_;
  std::size_t alternates_left_out_ = 0;
  struct Unknown {
    std::string symbol;
    std::size_t in_water = 0, elsewhere = 0;
  };
  std::vector<Unknown> unknown_;
  std::map<std::string, std::int32_t, std::less<>> unknown_of_;
};

/// Marks the residues of helices and strands; a residue in both belongs to the helix. Returns one sentence if some
/// records name missing residues, else an empty text.
std::string markElements(MoleculeArrays& molecule, const std::vector<ParsedSecondaryStructure>& elements);

/// Replaces the molecule by its assembly `name`. Copies of a chain are named, …
std::optional<Problem> applyAssembly(GrowingMolecule& molecule, const std::vector<ParsedAssembly>& assemblies,
                                     const std::string& name, const std::string& file);

/// The Problem "more than 25 million atoms".
Problem tooManyAtoms(const std::string& file, std::size_t line);

/// The Problem "the file has 3 models; there is no model 7".
Problem noSuchModel(const std::string& file, int asked, int models);

/// The Problem "a file of this format describes no biological assembly".
Problem noAssembly(const std::string& file);

/// True if the text, the beginning of a file, is a CIF of the small-molecule dictionary, which readMmcif() passes to
/// readSmallCif().
bool isSmallMoleculeCif(std::string_view text);
Expected<Molecule> readSmallCif(TextSource& text, const ReadOptions& options);

/// Parses the whole of `text`, except surrounding whitespace, as a finite number; false if it is not one.
bool parseNumber(std::string_view text, double& value);

/// Shortens `text` for a message: at most 24 characters, unprintable bytes as '?'.
std::string inQuotes(std::string_view text);

}  // namespace moltact
