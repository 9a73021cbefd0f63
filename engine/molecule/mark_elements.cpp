// Marks the helices and strands recorded in a file on the residues that they name.
#include <algorithm>
#include <functional>
#include <unordered_map>

#include "engine/language/catalogue.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

struct Where {
  std::string_view chain;
  int number;
  char insertion;
  friend bool operator==(const Where&, const Where&) = default;
};

struct WhereHash {
  std::size_t operator()(const Where& w) const {
    return std::hash<std::string_view>()(w.chain) ^
           (std::size_t(unsigned(w.number)) << 8 | static_cast<unsigned char>(w.insertion)) * 0x9E3779B97F4A7C15ull;
  }
};

}  // namespace

std::string markElements(MoleculeArrays& molecule, const std::vector<ParsedSecondaryStructure>& elements) {
  if (elements.empty()) return {};
  std::unordered_map<Where, std::uint32_t, WhereHash> at;
  for (std::uint32_t r = 0; r < molecule.residues.size(); ++r) {
    const Residue& residue = molecule.residues[r];
    if (residue.kind == ResidueKind::AminoAcid)
      at.emplace(Where{molecule.chains[residue.chain].name, residue.number, residue.insertion}, r);
  }
  std::size_t missing = 0;
  // Helices last, because they override strands.
  for (const SecondaryStructure kind : {SecondaryStructure::Strand, SecondaryStructure::Helix})
    for (const ParsedSecondaryStructure& element : elements) {
      if (element.structure.kind != kind) continue;
      const auto first = at.find({element.chain, element.first.number, element.first.insertion});
      const auto last = at.find({element.chain, element.last.number, element.last.insertion});
      if (first == at.end() || last == at.end() || last->second < first->second) {
        ++missing;
        continue;
      }
      // A strand of two sheets is recorded in each, possibly with different lengths: it counts once.
      const RecordedStructure before = molecule.residues[first->second].recorded;
      bool begins = before.kind != kind || before.begins;
      for (std::uint32_t r = first->second; r <= last->second; ++r) {
        Residue& residue = molecule.residues[r];
        if (residue.kind != ResidueKind::AminoAcid) continue;
        residue.recorded = element.structure;
        residue.recorded.begins = begins;
        begins = false;
      }
    }
  if (missing == 0) return {};
  return trnf("{0} helix or strand of the file's records names residues that are not among the atoms.",
              "{0} helices and strands of the file's records name residues that are not among the atoms.", missing,
              missing);
}

}  // namespace moltact
