// The parsed form of a selection: what selection_parser.cpp makes and selection.cpp evaluates. Plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

struct Molecule;

enum class SelectionKind : std::uint8_t {
  All,
  Chain,
  Residue,
  Resname,
  Name,
  Element,
  AtomIndex,
  Ligand,
  Class,
  Within,
  BondedTo,
  Not,
  And,
  Or
};

/// Numbers from `first` to `last`, both included.
struct NumberRange {
  long first = 0, last = 0;
  char insertion = ' ';  ///< of a single residue; a space selects the number with every insertion code
};

/// "10-20", "52A"
std::string rangeText(const NumberRange& range);

/// Atoms that a word of the language stands for by itself, as 'helix' does: a row of selection_classes.cpp.
struct AtomClass {
  std::string_view word;
  std::string_view meaning;  ///< for the reference of authors, in English
  const char* noun;          ///< for a student, in the middle of a sentence: "a helix"; in English
  const char* missing;       ///< "there is no helix in {0}"; in English
  /// Sets to 1 what belongs to it; `mask` has a 0 for each atom.
  void (*mark)(const Molecule& molecule, std::vector<char>& mask);
};

std::span<const AtomClass> atomClasses();

struct SelectionNode {
  SelectionKind kind = SelectionKind::All;
  std::size_t column = 1;                            ///< where its word stands in the text
  std::vector<std::size_t> columns;                  ///< where each of its names, numbers or elements stands
  std::vector<std::string> names;                    ///< chains, residue names, atom names
  std::vector<NumberRange> numbers;                  ///< residues, atom indices
  std::vector<std::uint8_t> elements;                ///< atomic numbers
  double distance_A = 0.0;                           ///< of Within
  const AtomClass* atom_class = nullptr;             ///< of Class
  std::shared_ptr<const SelectionNode> left, right;  ///< `left` alone for Within, BondedTo, Not
};

/// One word of the language and what may follow it.
struct SelectionWord {
  enum class Takes : std::uint8_t { Nothing, Names, OptionalNames, Residues, Indices, Elements };
  std::string_view word;
  SelectionKind kind;
  Takes takes;
  std::string_view meaning;  ///< for the reference of authors
  const AtomClass* atom_class = nullptr;
};

/// Every word that stands for atoms by itself (not `within`, `bonded`, `and`, `or`, `not`).
const std::vector<SelectionWord>& selectionWords();

}  // namespace moltact
