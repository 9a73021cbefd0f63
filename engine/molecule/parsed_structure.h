// What a format's reader hands on before the rules of reader.h are applied: the atoms of one model as the
// file has them. Inside engine/molecule only. Units: angstrom.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/text.h"
#include "engine/molecule/reader.h"

namespace moltact {

struct ParsedAtom {
  std::string name;         ///< "CA"
  std::string residue;      ///< "ALA"
  std::string chain;        ///< "A", as authors name it
  std::string label_chain;  ///< mmCIF's label_asym_id; empty in other formats
  std::string element;      ///< as the file writes it, used where atomic_number is 0
  Vec3 position_A{0.0};
  double occupancy = 1.0;
  std::size_t line = 0;  ///< in the file, from 1; 0 where not known
  int number = 0;        ///< residue number
  int atomic_number = 0;
  char insertion = ' ';
  char alternate = ' ';  ///< alternate location, a space where there is none
  bool hetero = false;   ///< HETATM
};

/// A turn and a shift that copy a part of the molecule into its biological assembly.
struct ParsedOperator {
  glm::dmat3 turn{1.0};
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

struct ParsedStructure {
  std::string id, title;
  std::vector<ParsedAtom> atoms;  ///< of the model asked for
  std::vector<ParsedAssembly> assemblies;
  std::vector<std::string> warnings;
  int models = 1;  ///< in the file
};

/// The readers behind the table of formats. `text` is the unpacked content; `file` names it in problems.
Expected<Molecule> readPdb(std::string_view text, const std::string& file, const ReadOptions& options);
Expected<Molecule> readMmcif(std::string_view text, const std::string& file, const ReadOptions& options);
Expected<Molecule> readXyzr(std::string_view text, const std::string& file, const ReadOptions& options);

/// Applies the rules of reader.h: alternates, waters, assembly, radii, residues and chains.
Expected<Molecule> buildMolecule(ParsedStructure parsed, const std::string& file, const ReadOptions& options);

/// "the file has 3 models; there is no model 7".
Problem noSuchModel(const std::string& file, int asked, int models);

/// A number of a person's text: the whole of `text` (blanks around it allowed) as a finite double, or false.
bool parseNumber(std::string_view text, double& value);

/// `text` fit to be shown in a message: at most 24 characters, unprintable bytes as '?'.
std::string inQuotes(std::string_view text);

}  // namespace moltact
