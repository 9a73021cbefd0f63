// Selections of atoms, in the language that molecular viewers share. Not for the haptic thread. Units: angstrom.
//
//   all                         every atom
//   chain A B                   chains by name                    (one or more names)
//   residue 52  residue 10-20   residues by number, as in the file (one or more numbers or ranges;
//                               52A with its insertion code)
//   resname HEM                 residues by name
//   name CA                     atoms by name in their residue
//   element O                   atoms by element symbol, in capitals or small letters
//   atom 3  atom 0-5            atoms by index, counted from 0 in file order as kept
//   ligand  ligand HEM          residues that are neither polymer nor water nor ion; of that name
//   protein nucleic water ion   kinds of residue
//   helix sheet                 secondary structure, by the file's records, else by hydrogen bonds
//   backbone sidechain          parts of amino acids and nucleotides
//   hydrophobic polar charged   amino acids by their side chains
//   surface                     atoms that a probe of 1.4 Å can touch
//   heme sugar buffer metal     kinds of ligands and of elements
//   within 5 Å of (…)           atoms whose centres lie that near to the centre of a selected atom, those included
//   bonded to (…)               atoms with a bond to a selected atom, selected themselves or not
//   not … · … and … · … or …    in that order of binding; round brackets group
//
// Names are as in the file, in capitals or small; the words of the language are in small letters. A name that is also a
// word of the language, or has spaces or brackets in it, goes into double quotes.
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

/// A parsed selection; cheap to copy. A default one selects nothing.
class Selection {
 public:
  Selection() = default;
  Selection(std::string text, std::shared_ptr<const SelectionNode> root)
      : text_(std::move(text)), root_(std::move(root)) {}

  /// As the author wrote it.
  const std::string& text() const { return text_; }
  bool given() const { return root_ != nullptr; }

  /// The indices of the selected atoms, ascending. Time grows with the number of atoms; `within` uses a grid.
  std::vector<std::uint32_t> select(const Molecule& molecule) const;

  /// Its name for a student, in the middle of a sentence: "an oxygen atom", "residue 52", "the ligand HEM"; where the
  /// selection is not so simple, "the place you look for".
  std::string noun() const;

  /// Why it selects nothing in this molecule, as "ligand 'BTX' is not in 1stp (ligands: BTN)": its first part without
  /// atoms and what there is instead; a general sentence where every part has atoms of its own. Line 0, the column of
  /// that part within the text, and what would mend it.
  Problem whyEmpty(const Molecule& molecule) const;

  /// Names and numbers in it that no atom of the molecule has, though the whole selects some: "resname HEM HEX" in a
  /// molecule without HEX. As above; most are slips of the author.
  std::vector<Problem> idleNames(const Molecule& molecule) const;

  /// The same as the author wrote it.
  friend bool operator==(const Selection& a, const Selection& b) { return a.text_ == b.text_; }

 private:
  std::string text_;
  std::shared_ptr<const SelectionNode> root_;
};

/// A selection from its text. A problem has line 0 and the column within `text`.
Expected<Selection> parseSelection(std::string_view text);

/// The deepest nesting of brackets and `not` that is read.
inline constexpr int kDeepestSelection = 64;

}  // namespace moltact
