// The parsed form of a selection: what selection_parser.cpp makes and selection.cpp evaluates. Plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

enum class SelectionKind : std::uint8_t {
  All,
  Chain,
  Residue,
  Resname,
  Name,
  Element,
  AtomIndex,
  Ligand,
  Protein,
  Nucleic,
  Water,
  Ion,
  Within,
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

struct SelectionNode {
  SelectionKind kind = SelectionKind::All;
  std::size_t column = 1;                            ///< where its word stands in the text
  std::vector<std::size_t> columns;                  ///< where each of its names, numbers or elements stands
  std::vector<std::string> names;                    ///< chains, residue names, atom names
  std::vector<NumberRange> numbers;                  ///< residues, atom indices
  std::vector<std::uint8_t> elements;                ///< atomic numbers
  double distance_A = 0.0;                           ///< of Within
  std::shared_ptr<const SelectionNode> left, right;  ///< `left` alone for Within and Not
};

/// One word of the language and what may follow it.
struct SelectionWord {
  enum class Takes : std::uint8_t { Nothing, Names, OptionalNames, Residues, Indices, Elements };
  std::string_view word;
  SelectionKind kind;
  Takes takes;
  std::string_view meaning;  ///< for the reference of authors
};

/// Every word that stands for atoms by itself (not `within`, `and`, `or`, `not`).
const std::vector<SelectionWord>& selectionWords();

}  // namespace moltact
