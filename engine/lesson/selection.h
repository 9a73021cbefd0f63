// Selections of atoms, in the language that molecular viewers share. Not for the haptic thread. Unit: angstrom.
//
//   all                         every atom
//   chain A B                   chains by name                    (one or more names)
//   residue 52  residue 10-20   residues by number, as in the file (one or more numbers or ranges;
//                               52A with its insertion code)
//   resname HEM                 residues by name
//   name CA                     atoms by name in their residue
//   element O                   atoms by element symbol, in any case
//   atom 3  atom 0-5            atoms by index, counted from 0 in file order as kept
//   ligand  ligand HEM          residues that are neither polymer nor water nor ion; of that name
//   protein nucleic water ion   kinds of residue
//   helix sheet                 secondary structure, by the file's records, else by hydrogen bonds
//   backbone sidechain          parts of amino acids and nucleotides
//   hydrophobic polar charged   amino acids by their side chains
//   surface                     atoms that a probe of 1.4 Å can touch
//   heme sugar buffer metal     kinds of ligands and of elements
//   within 5 Å of (…)           atoms whose centres are within this distance of a selected atom's centre, inclusive
//   bonded to (…)               atoms with a bond to a selected atom, whether selected themselves or not
//   not … · … and … · … or …    in descending precedence; parentheses group
//
// Names are written as in the file, in any case; the words of the language are lower case. A name that is also a word
// of the language, or that contains spaces or parentheses, requires double quotes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

struct Molecule;
struct SelectionNode;

/// A parsed selection; cheap to copy. A default-constructed one selects nothing.
class Selection {
 public:
  Selection() = default;
  Selection(std::string text, std::shared_ptr<const SelectionNode> root)
      : text_(std::move(text)), root_(std::move(root)) {}

  /// The author's text.
  const std::string& text() const { return text_; }
  bool given() const { return root_ != nullptr; }

  /// The indices of the selected atoms, ascending. The time is proportional to the number of atoms; `within` uses a
  /// grid.
  std::vector<std::uint32_t> select(const Molecule& molecule) const;

  /// A noun phrase for students within a sentence: "an oxygen atom", "residue 52", "the ligand HEM". For complex
  /// selections: "the place you look for".
  std::string noun() const;

  /// Why it selects no atom of this molecule: "ligand 'BTX' is not in 1stp (ligands: BTN)". Describes the first part
  /// without atoms and the alternatives; if every part has atoms, a general sentence. The Problem has line 0, the
  /// column of that part within the text, and a remedy.
  Problem whyEmpty(const Molecule& molecule) const;

  /// The names and numbers that match no atom although the whole selection does: "resname HEM HEX" in a molecule
  /// without HEX. Most are typing errors. Places as in whyEmpty().
  std::vector<Problem> unmatchedNames(const Molecule& molecule) const;

  /// Compares the texts.
  friend bool operator==(const Selection& a, const Selection& b) { return a.text_ == b.text_; }

 private:
  std::string text_;
  std::shared_ptr<const SelectionNode> root_;
};

/// Parses a selection. A Problem has line 0 and the column within `text`.
Expected<Selection> parseSelection(std::string_view text);

/// The maximum nesting of parentheses and `not`.
inline constexpr int kDeepestSelection = 64;

}  // namespace moltact
