// The bonds of amino acids and nucleotides by atom names, according to the Chemical Component Dictionary of the PDB.
#include <algorithm>
#include <map>
#include <string>

#include "engine/structure/bonds.h"

namespace moltact {
namespace {

// "CA-CB CG=OD1": a single bond, a double bond. Aromatic rings as in Kekulé's formula.
struct Formula {
  std::string_view code, bonds;
};

constexpr std::string_view kPeptide = "N-CA CA-C C=O C-OXT CA-CB ";
constexpr std::string_view kSugar =
    "P=OP1 P-OP2 P-OP3 P-O5' O5'-C5' C5'-C4' C4'-O4' C4'-C3' C3'-O3' C3'-C2' C2'-O2' C2'-C1' C1'-O4' ";

constexpr Formula kAminoFormulas[] = {
    {"ALA", ""},
    {"ARG", "CB-CG CG-CD CD-NE NE-CZ CZ-NH1 CZ=NH2"},
    {"ASN", "CB-CG CG=OD1 CG-ND2"},
    {"ASP", "CB-CG CG=OD1 CG-OD2"},
    {"CYS", "CB-SG"},
    {"GLN", "CB-CG CG-CD CD=OE1 CD-NE2"},
    {"GLU", "CB-CG CG-CD CD=OE1 CD-OE2"},
    {"GLY", ""},
    {"HIS", "CB-CG CG-ND1 CG=CD2 ND1=CE1 CE1-NE2 NE2-CD2"},
    {"ILE", "CB-CG1 CB-CG2 CG1-CD1"},
    {"LEU", "CB-CG CG-CD1 CG-CD2"},
    {"LYS", "CB-CG CG-CD CD-CE CE-NZ"},
    {"MET", "CB-CG CG-SD SD-CE"},
    {"MSE", "CB-CG CG-SE SE-CE"},
    {"PHE", "CB-CG CG=CD1 CD1-CE1 CE1=CZ CZ-CE2 CE2=CD2 CD2-CG"},
    {"PRO", "CB-CG CG-CD CD-N"},
    {"SER", "CB-OG"},
    {"THR", "CB-OG1 CB-CG2"},
    {"TRP", "CB-CG CG=CD1 CD1-NE1 NE1-CE2 CE2=CD2 CD2-CG CE2-CZ2 CZ2=CH2 CH2-CZ3 CZ3=CE3 CE3-CD2"},
    {"TYR", "CB-CG CG=CD1 CD1-CE1 CE1=CZ CZ-CE2 CE2=CD2 CD2-CG CZ-OH"},
    {"VAL", "CB-CG1 CB-CG2"},
};

constexpr std::string_view kPurine = "C1'-N9 N9-C8 C8=N7 N7-C5 C5-C4 C4-N9 N3-C4 C2-N3 N1-C2 C6-N1 C5-C6 ";
constexpr std::string_view kPyrimidine = "C1'-N1 N1-C2 C2=O2 C2-N3 C4-C5 C5=C6 C6-N1 ";

struct BaseFormula {
  std::string_view codes, ring, rest;
};
constexpr BaseFormula kBases[] = {
    {"A DA", kPurine, "C6-N6"},
    {"G DG", kPurine, "C6=O6 C2-N2"},
    {"C DC", kPyrimidine, "N3=C4 C4-N4"},
    {"U DU", kPyrimidine, "N3-C4 C4=O4"},
    {"DT T", kPyrimidine, "N3-C4 C4=O4 C5-C7"},
};

std::string_view takeWord(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

using Bonds = std::vector<NamedBond>;

void addBonds(Bonds& to, std::string_view bonds) {
  for (std::string_view word = takeWord(bonds); !word.empty(); word = takeWord(bonds)) {
    const std::size_t sign = word.find_first_of("-=");
    to.push_back(
        {word.substr(0, sign), word.substr(sign + 1), word[sign] == '=' ? BondOrder::Double : BondOrder::Single});
  }
}

// The double bonds of a purine's six-membered ring differ between adenine and guanine.
void setDouble(Bonds& bonds, std::string_view first, std::string_view second) {
  for (NamedBond& b : bonds)
    if (b.first == first && b.second == second) b.order = BondOrder::Double;
}

std::map<std::string_view, Bonds> makeFormulas() {
  std::map<std::string_view, Bonds> out;
  for (const Formula& f : kAminoFormulas) {
    Bonds& bonds = out[f.code];
    addBonds(bonds, kPeptide);
    addBonds(bonds, f.bonds);
  }
  for (const BaseFormula& f : kBases) {
    Bonds bonds;
    addBonds(bonds, kSugar);
    addBonds(bonds, f.ring);
    addBonds(bonds, f.rest);
    if (f.ring == kPurine) {
      setDouble(bonds, "C5", "C4");
      if (f.rest == "C6-N6")
        setDouble(bonds, "C2", "N3"), setDouble(bonds, "C6", "N1");
      else
        setDouble(bonds, "C2", "N3");
    }
    std::string_view codes = f.codes;
    for (std::string_view code = takeWord(codes); !code.empty(); code = takeWord(codes)) out[code] = bonds;
  }
  return out;
}

struct Alias {
  std::string_view residue, given, name;  // empty residue: any
};
constexpr Alias kAliases[] = {
    {"", "O1P", "OP1"}, {"", "O2P", "OP2"},   {"", "O3P", "OP3"},  {"", "O5*", "O5'"}, {"", "C5*", "C5'"},
    {"", "C4*", "C4'"}, {"", "O4*", "O4'"},   {"", "C3*", "C3'"},  {"", "O3*", "O3'"}, {"", "C2*", "C2'"},
    {"", "O2*", "O2'"}, {"", "C1*", "C1'"},   {"", "OT1", "O"},    {"", "OT2", "OXT"}, {"", "O1", "O"},
    {"", "O2", "OXT"},  {"ILE", "CD", "CD1"}, {"DT", "C5M", "C7"}, {"T", "C5M", "C7"},
};

/// Names of charge states have the same heavy atoms.
std::string_view formulaCode(std::string_view name) {
  if (name == "HID" || name == "HIE" || name == "HIP" || name == "HSD" || name == "HSE" || name == "HSP") return "HIS";
  if (name == "CYX" || name == "CYM") return "CYS";
  if (name == "ASH") return "ASP";
  if (name == "GLH") return "GLU";
  if (name == "LYN") return "LYS";
  return name;
}

}  // namespace

std::span<const NamedBond> formulaBonds(std::string_view residue_name) {
  static const std::map<std::string_view, Bonds> formulas = makeFormulas();
  const auto found = formulas.find(formulaCode(residue_name));
  return found == formulas.end() ? std::span<const NamedBond>() : found->second;
}

std::string_view formulaName(std::string_view residue_name, std::string_view atom_name) {
  for (const Alias& a : kAliases) {
    if (a.given != atom_name) continue;
    // A pyrimidine's own O2 does not belong to the end of a protein.
    const bool of_protein = a.name == "O" || a.name == "OXT";
    if (a.residue.empty() ? (!of_protein || residue_name.size() == 3) : a.residue == residue_name) return a.name;
  }
  return atom_name;
}

}  // namespace moltact
