#include "engine/molecule/element_of_name.h"

#include <algorithm>
#include <cctype>
#include <gemmi/elem.hpp>
#include <gemmi/resinfo.hpp>
#include <string>

#include "engine/molecule/residue_kind.h"

namespace moltact {
namespace {

/// The letters alone, in upper case: "1HB" gives HB, "Na+" gives NA.
std::string letters(std::string_view name) {
  std::string out;
  for (const unsigned char c : name)
    if (std::isalpha(c)) out += static_cast<char>(std::toupper(c));
  return out;
}

int numberOf(std::string_view symbol) { return gemmi::Element(std::string(symbol)).atomic_number(); }

// Names of ions in CHARMM's force field.
struct Ion {
  std::string_view name, symbol;
};
constexpr Ion kIons[] = {{"SOD", "Na"}, {"CLA", "Cl"}, {"POT", "K"},  {"CAL", "Ca"}, {"CES", "Cs"},
                         {"LIT", "Li"}, {"RUB", "Rb"}, {"BAR", "Ba"}, {"CAD", "Cd"}};

}  // namespace

bool isNucleotideName(std::string_view residue) {
  if (residue.size() > 1 && (residue[0] == 'D' || residue[0] == 'R')) residue.remove_prefix(1);
  if (residue.size() == 2 && (residue[1] == '3' || residue[1] == '5' || residue[1] == 'N')) residue.remove_suffix(1);
  return residue.size() == 1 && std::string_view("ACGTU").find(residue[0]) != std::string_view::npos;
}

bool isVirtualSite(std::string_view atom, std::string_view residue) {
  const std::string name = letters(atom);
  return isWaterName(residue) && !name.empty() && name[0] != 'H' && name[0] != 'O' && name[0] != 'D';
}

int elementOfName(std::string_view atom, std::string_view residue) {
  const std::string name = letters(atom), of = letters(residue);
  if (name.empty()) return 0;
  const std::string_view first = std::string_view(name).substr(0, 1), two = std::string_view(name).substr(0, 2);
  const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(residue));
  const bool polymer = info.is_amino_acid() || info.is_nucleic_acid() || isNucleotideName(residue);
  if (polymer || isWaterName(residue)) {
    if (two == "SE" && info.is_amino_acid()) return numberOf("Se");
    return numberOf(first);
  }
  if (name == of) {
    for (const Ion& ion : kIons)
      if (ion.name == name) return numberOf(ion.symbol);
    if (name.size() <= 2)
      if (const int whole = numberOf(name)) return whole;
  }
  static constexpr std::string_view kTwo[] = {"CL", "BR", "FE", "ZN", "MG", "MN", "CU", "NI", "SI", "SE"};
  if (std::find(std::begin(kTwo), std::end(kTwo), two) != std::end(kTwo)) return numberOf(two);
  return numberOf(first);
}

}  // namespace moltact
