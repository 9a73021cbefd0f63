// The syntax tree of a selection: selection_parser.cpp builds it, selection.cpp evaluates it. Plain data.
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

/// The numbers from `first` to `last` inclusive.
struct NumberRange {
  long first = 0, last = 0;
  char insertion = ' ';  ///< of a single residue; a space matches every insertion code
};

/// "10-20", "52A"
std::string rangeText(const NumberRange& range);

/// A class of atoms with a word of its own, such as 'helix': a row of selection_classes.cpp.
struct AtomClass {
  std::string_view word;
  std::string_view meaning;  ///< for the authors' reference, in English
  const char* noun;          ///< for a student, within a sentence: "a helix"; in English
  const char* missing;       ///< "there is no helix in {0}"; in English
  /// Sets the mask's entries of its atoms to 1. `mask` has a 0 for each atom.
  void (*mark)(const Molecule& molecule, std::vector<char>& mask);
};

std::span<const AtomClass> atomClasses();

struct SelectionNode {
  SelectionKind kind = SelectionKind::All;
  std::size_t column = 1;                            ///< column of its word in the text
  std::vector<std::size_t> columns;                  ///< columns of its names, numbers or elements
  std::vector<std::string> names;                    ///< chains, residue names, atom names
  std::vector<NumberRange> numbers;                  ///< residues, atom indices
  std::vector<std::uint8_t> elements;                ///< atomic numbers
  double distance_A = 0.0;                           ///< of Within
  const AtomClass* atom_class = nullptr;             ///< of Class
  std::shared_ptr<const SelectionNode> left, right;  ///< Within, BondedTo and Not use `left` only
};

/// A word of the language and its possible arguments.
struct SelectionWord {
  enum class Takes : std::uint8_t { Nothing, Names, OptionalNames, Residues, Indices, Elements };
  std::string_view word;
  SelectionKind kind;
  Takes takes;
  std::string_view meaning;  ///< for the authors' reference
  const AtomClass* atom_class = nullptr;
};

/// Every word that selects atoms by itself (not `within`, `bonded`, `and`, `or`, `not`).
const std::vector<SelectionWord>& selectionWords();

}  // namespace moltact
