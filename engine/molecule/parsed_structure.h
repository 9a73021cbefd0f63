// The atoms that a format's reader hands on one by one, and the builder that makes a molecule of them by the rules of
// reader.h. Nothing but the molecule itself grows with the file. Inside engine/molecule only. Units: angstrom.
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

/// One atom as the file has it. The texts need last no longer than the call that takes them.
struct ParsedAtom {
  std::string_view name;         ///< "CA"
  std::string_view residue;      ///< "ALA"
  std::string_view chain;        ///< "A", as authors name it
  std::string_view label_chain;  ///< mmCIF's label_asym_id; empty in other formats
  std::string_view element;      ///< as the file writes it, used where atomic_number is 0
  Vec3 position_A{0.0};
  double occupancy = 1.0;
  double b_factor_A2 = 0.0;
  double radius_A = -1.0;  ///< as the file has it; below zero: the element's
  double charge_e = 0.0;   ///< partial charge, of a format that has charges
  std::size_t line = 0;    ///< in the file, from 1; 0 where not known
  int number = 0;          ///< residue number
  int atomic_number = 0;
  char insertion = ' ';
  char alternate = ' ';  ///< alternate location, a space where there is none
  bool hetero = false;   ///< HETATM
};

/// A turn and a shift that copy a part of the molecule into its biological assembly.
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

/// A helix or a strand as a file records it: from one residue of a chain to another, both included.
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

/// The arrays of a molecule while a reader appends to them.
struct MoleculeArrays {
  std::vector<Atom> atoms;
  std::vector<Sphere> spheres;   ///< of each atom
  std::vector<float> charges_e;  ///< of each atom; empty: the format has none
  std::vector<Residue> residues;
  std::vector<Chain> chains;
};

/// A molecule that grows: residues and chains are runs of atoms, in the order in which these come.
class GrowingMolecule {
 public:
  /// The residue of an atom with its chains; texts as in ParsedAtom.
  struct Place {
    std::string_view residue, chain, label_chain;
    int number = 0;
    char insertion = ' ';
    RecordedStructure recorded{};
  };
  /// `names_label_chains`: their names are needed later, for an assembly; otherwise it is only kept which residues have
  /// the same.
  /// `has_charges`: the atoms bring partial charges.
  explicit GrowingMolecule(bool names_label_chains = false, bool has_charges = false)
      : names_label_chains_(names_label_chains), has_charges_(has_charges) {}
  /// Makes room for about so many atoms.
  void expect(std::size_t atoms);
  /// The next atom; what follows in the same residue and chain belongs to one.
  void add(const PlacedAtom& atom, float charge_e, const Place& place, bool hetero) {
    put(arrays.atoms.size(), atom, charge_e, place, hetero);
  }
  /// The same, where the atom takes the place of one that is in the list already, in the order of the list.
  void put(std::size_t at, const PlacedAtom& atom, float charge_e, const Place& place, bool hetero);
  /// The atom and its charge (0 without charges). `atom` in range.
  PlacedAtom at(std::size_t atom) const {
    return {{arrays.atoms[atom]}, {arrays.spheres[atom].centre_A}, arrays.spheres[atom].radius_A};
  }
  float charge_e(std::size_t atom) const { return has_charges_ ? arrays.charges_e[atom] : 0.0f; }
  /// A Problem where the next atom would be one too many, or too much for the memory that a molecule may take.
  std::optional<Problem> full(const std::string& file, std::size_t line) const;
  /// The memory that it takes (unit: byte).
  std::size_t bytes() const;
  /// The last residue is whole.
  void close();
  /// The label_chain of a residue; without names a text that is the same for the same one.
  std::string_view labelChain(std::size_t residue) const;
  bool namesLabelChains() const { return names_label_chains_; }
  bool hasCharges() const { return has_charges_; }

  MoleculeArrays arrays;
  std::vector<bool> hetero_of;  ///< of each residue

 private:
  bool names_label_chains_, has_charges_;
  std::string label_chain_;  // of the last residue
  std::vector<std::uint32_t>
      label_of_;  // of each residue: index into labels_ from 1, or without names a hash; 0: none. Empty: all have none
  std::vector<ShortText> labels_;  // one for each run of it
  std::size_t text_bytes_ = 0;     // of names that are too long to stand in their own objects
};

/// Takes the atoms of one model and keeps what the rules of reader.h keep.
class MoleculeBuilder {
 public:
  /// `text`, which must outlive it, gives the file's name, and by its length how many atoms to expect.
  /// `has_charges`: the format has a partial charge for each atom.
  MoleculeBuilder(const TextSource& text, const ReadOptions& options, bool has_charges = false);
  std::optional<Problem> add(const ParsedAtom& atom);
  Expected<Molecule> finish(ParsedHeader head);

 private:
  // Facts of an atom beyond those that become part of the molecule, kept while its place is not complete.
  struct Waiting {
    PlacedAtom atom;
    float charge_e = 0.0f;
    std::uint64_t name = 0;  // of the whole name
    double occupancy = 1.0;
    std::uint32_t residue = 0;  // index into residues_
    std::int32_t unknown = -1;  // index into unknown_, where no radius is known
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
  std::size_t atoms_ = 0, before_ = 0;  // atoms so far, and bytes of text before the first
  // The place in a chain that the last atoms belong to: one residue, or some that are alternatives.
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

/// Marks the residues of the elements; a residue of a helix and of a strand belongs to the helix. One sentence where some
/// name residues that are not there, nothing otherwise.
std::string markElements(MoleculeArrays& molecule, const std::vector<ParsedSecondaryStructure>& elements);

/// Puts the assembly `name` in the place of the molecule. Copies of a chain are named, …
std::optional<Problem> applyAssembly(GrowingMolecule& molecule, const std::vector<ParsedAssembly>& assemblies,
                                     const std::string& name, const std::string& file);

/// "more than 25 million atoms".
Problem tooManyAtoms(const std::string& file, std::size_t line);

/// "the file has 3 models; there is no model 7".
Problem noSuchModel(const std::string& file, int asked, int models);

/// "a file of this format describes no biological assembly".
Problem noAssembly(const std::string& file);

/// True where the text, the beginning of a file, is a CIF of the dictionary for small molecules, which readMmcif() hands
/// to readSmallCif().
bool isSmallMoleculeCif(std::string_view text);
Expected<Molecule> readSmallCif(TextSource& text, const ReadOptions& options);

/// A number of a person's text: the whole of `text` (blanks around it allowed) as a finite double, or false.
bool parseNumber(std::string_view text, double& value);

/// `text` fit to be shown in a message: at most 24 characters, unprintable bytes as '?'.
std::string inQuotes(std::string_view text);

}  // namespace moltact
