#include "engine/lesson/selection_slips.h"

#include <algorithm>
#include <cctype>

#include "engine/core/text.h"
#include "engine/lesson/suggestion.h"
#include "engine/structure/amino_acids.h"

namespace moltact {
namespace {

struct Other {
  std::string_view theirs, ours;
  bool takes = false;  ///< requires names or numbers
};

// Words of PyMOL, VMD, RasMol, ChimeraX and MDAnalysis, and variants of our own words.
constexpr Other kOthers[] = {
    {"resi", "residue", true},
    {"resid", "residue", true},
    {"resnum", "residue", true},
    {"res", "residue", true},
    {"residues", "residue", true},
    {"resn", "resname", true},
    {"restype", "resname", true},
    {"segid", "chain", true},
    {"segi", "chain", true},
    {"chains", "chain", true},
    {"elem", "element", true},
    {"symbol", "element", true},
    {"type", "element", true},
    {"index", "atom", true},
    {"id", "atom", true},
    {"serial", "atom", true},
    {"atoms", "atom", true},
    {"hetatm", "ligand"},
    {"hetero", "ligand"},
    {"het", "ligand"},
    {"organic", "ligand"},
    {"ligands", "ligand"},
    {"polymer", "protein"},
    {"amino", "protein"},
    {"aminoacid", "protein"},
    {"dna", "nucleic"},
    {"rna", "nucleic"},
    {"nucleicacid", "nucleic"},
    {"waters", "water"},
    {"solvent", "water"},
    {"hoh", "water"},
    {"ions", "ion"},
    {"helices", "helix"},
    {"alpha", "helix"},
    {"strand", "sheet"},
    {"strands", "sheet"},
    {"beta", "sheet"},
    {"sheets", "sheet"},
    {"bb", "backbone"},
    {"mainchain", "backbone"},
    {"side-chain", "sidechain"},
    {"sidechains", "sidechain"},
    {"sc", "sidechain"},
    {"nonpolar", "hydrophobic"},
    {"apolar", "hydrophobic"},
    {"exposed", "surface"},
    {"metals", "metal"},
    {"haem", "heme"},
    {"hem", "heme"},
    {"sugars", "sugar"},
    {"saccharide", "sugar"},
    {"glycan", "sugar"},
    {"everything", "all"},
    {"around", "within 5 Å of"},
    {"near", "within 5 Å of"},
    {"bound_to", "bonded to"},
    {"neighbor", "bonded to"},
};

bool isNumber(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isdigit(c) != 0 || c == '-' || c == '+' || c == ',';
  }) && std::isdigit(static_cast<unsigned char>(text.back())) != 0;
}

std::string inCapitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::string withBlanks(std::string_view numbers) {
  std::string out(numbers);
  std::replace(out.begin(), out.end(), '+', ' ');
  return out;
}

std::string inOurLanguage(std::string_view word, std::string_view next) {
  const std::string small = lower(std::string(word));
  for (const Other& o : kOthers)
    if (o.theirs == small)
      return o.takes && !next.empty() && next != "(" && next != ")" ? std::string(o.ours) + ' ' + withBlanks(next)
                                                                    : std::string(o.ours);
  if (isNumber(word)) return "residue " + withBlanks(word);
  // "Glu", "Glu 35", "Glu35", "GLU-35"
  std::string_view letters = word.substr(0, std::min<std::size_t>(3, word.size())),
                   number = word.substr(letters.size());
  if (number.starts_with('-')) number.remove_prefix(1);
  const AminoAcid* known = nullptr;
  for (const AminoAcid& a : aminoAcids())
    if (a.code == inCapitals(letters) || lower(std::string(a.name)) == small) known = &a;
  if (!known) return {};
  if (lower(std::string(known->name)) == small) number = {};
  if (number.empty() && isNumber(next)) number = next;
  if (isNumber(number)) return "residue " + withBlanks(number);
  return number.empty() ? "resname " + std::string(known->code) : std::string();
}

std::string otherLanguage(std::string_view word, std::string_view next) {
  const std::string meant = inOurLanguage(word, next);
  return meant.empty() ? std::string() : didYouMean(meant);
}

}  // namespace moltact
