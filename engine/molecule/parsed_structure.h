// The parsed atoms that a format's reader passes on one by one, and the builder that assembles them into a molecule by
// the rules of reader.h. Only the molecule itself grows with the file. Internal to engine/molecule and
// engine/trajectory. Units: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/molecule/molecule_storage.h"
#include "engine/molecule/radius_tables.h"
#include "engine/molecule/reader.h"
#include "engine/molecule/text_source.h"

namespace moltact {

/// The largest amount of a formal charge (unit: elementary charge); the CTfile formats allow -15 to 15.
inline constexpr int kMaxFormalCharge_e = 15;
/// Whether a number from a file can be a formal charge.
constexpr bool isFormalCharge(long long e) { return e >= -kMaxFormalCharge_e && e <= kMaxFormalCharge_e; }

/// The largest amount of a partial charge (unit: elementary charge). No atom has more; greater ones would overflow the
/// sums of forces.
inline constexpr int kMaxPartialCharge_e = 100;
/// Reads a partial charge. Returns the error's text, or an empty one if `charge_e` was set.
std::string partialChargeFault(std::string_view text, double& charge_e);

/// A file of bonds may list so many for each atom, on average.
inline constexpr std::size_t kMaxBondsAnAtom = 8;

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
  int formal_e = 0;        ///< formal charge; beyond kMaxFormalCharge_e: as 0
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

/// Receives the atoms of one model and applies the rules of reader.h.
class MoleculeBuilder {
 public:
  /// `text` must outlive the builder; it provides the file's name and, by its length, an estimate of the number of
  /// atoms. `has_charges`: the format has a partial charge for each atom.
  MoleculeBuilder(const TextSource& text, const ReadOptions& options, bool has_charges = false);
  std::optional<Problem> add(const ParsedAtom& atom);
  /// Counts an atom of the model that is left out.
  void skip() { ++in_file_; }
  Expected<Molecule> finish(ParsedHeader head);

 private:
  // An atom with the data needed until its residue is complete.
  struct Waiting {
    PlacedAtom atom;
    float charge_e = 0.0f;
    std::string name;  // the full name; the atom's is cut to its room
    double occupancy = 1.0;
    std::uint32_t residue = 0;  // index into residues_
    std::uint32_t in_file = 0;  // Molecule::numbers_in_file
    std::int32_t unknown = -1;  // index into unknown_ if the radius is unknown
    std::int8_t formal_e = 0;
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
  const RadiusTable& radii_;
  const TextSource& text_;
  std::string file_;
  MoleculeStorage out_;
  std::size_t atoms_ = 0, before_ = 0;  // number of atoms so far; bytes of text before the first
  std::uint32_t in_file_ = 0;           // the same, with those that were left out
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
std::optional<Problem> applyAssembly(MoleculeStorage& molecule, const std::vector<ParsedAssembly>& assemblies,
                                     const std::string& name, const std::string& file);

/// The Problem "the file has 3 models; there is no model 7".
Problem noSuchModel(const std::string& file, int asked, int models);

/// The Problem "a file of this format describes no biological assembly".
Problem noAssembly(const std::string& file);

/// The warning of a file whose format has charges, all of which are 0: they were not computed.
std::string allChargesZero();

/// True if the text, the beginning of a file, is a CIF of the small-molecule dictionary, which readMmcif() passes to
/// readSmallCif().
bool isSmallMoleculeCif(std::string_view text);
Expected<Molecule> readSmallCif(TextSource& text, const ReadOptions& options);

/// Parses the whole of `text`, except surrounding whitespace, as a finite number; false if it is not one.
bool parseNumber(std::string_view text, double& value);

/// A word of a line and its column, from 1.
struct LineWord {
  std::string_view text;
  std::size_t column = 0;
};
/// The first words of a line, at most 12, separated by blanks.
std::vector<LineWord> wordsOfLine(std::string_view line);

/// Shortens `text` for a message: at most 24 characters, unprintable bytes as '?'.
std::string inQuotes(std::string_view text);

}  // namespace moltact
