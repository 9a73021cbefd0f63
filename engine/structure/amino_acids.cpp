#include "engine/structure/amino_acids.h"

#include <algorithm>
#include <gemmi/resinfo.hpp>
#include <string>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

using enum SideChain;

constexpr AminoAcid kAminoAcids[] = {
    {"ALA", N_("alanine"), Hydrophobic, 0, 1.8},     {"ARG", N_("arginine"), Charged, 1, -4.5},
    {"ASN", N_("asparagine"), Polar, 0, -3.5},       {"ASP", N_("aspartic acid"), Charged, -1, -3.5},
    {"CYS", N_("cysteine"), Polar, 0, 2.5},          {"GLN", N_("glutamine"), Polar, 0, -3.5},
    {"GLU", N_("glutamic acid"), Charged, -1, -3.5}, {"GLY", N_("glycine"), Polar, 0, -0.4},
    {"HIS", N_("histidine"), Polar, 0, -3.2},        {"ILE", N_("isoleucine"), Hydrophobic, 0, 4.5},
    {"LEU", N_("leucine"), Hydrophobic, 0, 3.8},     {"LYS", N_("lysine"), Charged, 1, -3.9},
    {"MET", N_("methionine"), Hydrophobic, 0, 1.9},  {"PHE", N_("phenylalanine"), Hydrophobic, 0, 2.8},
    {"PRO", N_("proline"), Hydrophobic, 0, -1.6},    {"SER", N_("serine"), Polar, 0, -0.8},
    {"THR", N_("threonine"), Polar, 0, -0.7},        {"TRP", N_("tryptophan"), Hydrophobic, 0, -0.9},
    {"TYR", N_("tyrosine"), Polar, 0, -1.3},         {"VAL", N_("valine"), Hydrophobic, 0, 4.2},
};

/// A residue name that denotes a charge state.
struct State {
  std::string_view name, code;
  int charge_e;
};
constexpr State kStates[] = {{"ASH", "ASP", 0}, {"CYM", "CYS", -1}, {"CYX", "CYS", 0}, {"GLH", "GLU", 0},
                             {"HID", "HIS", 0}, {"HIE", "HIS", 0},  {"HIP", "HIS", 1}, {"HSD", "HIS", 0},
                             {"HSE", "HIS", 0}, {"HSP", "HIS", 1},  {"LYN", "LYS", 0}};

const AminoAcid* byCode(std::string_view code) {
  const auto found = std::lower_bound(std::begin(kAminoAcids), std::end(kAminoAcids), code,
                                      [](const AminoAcid& a, std::string_view c) { return a.code < c; });
  return found != std::end(kAminoAcids) && found->code == code ? found : nullptr;
}

const State* stateOf(std::string_view name) {
  const auto found =
      std::find_if(std::begin(kStates), std::end(kStates), [&](const State& s) { return s.name == name; });
  return found != std::end(kStates) ? found : nullptr;
}

}  // namespace

std::span<const AminoAcid> aminoAcids() { return kAminoAcids; }

const AminoAcid* aminoAcid(std::string_view residue_name) {
  if (const AminoAcid* known = byCode(residue_name)) return known;
  if (const State* state = stateOf(residue_name)) return byCode(state->code);
  // A modified residue has the letter of its parent amino acid.
  const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(residue_name));
  if (!info.is_amino_acid()) return nullptr;
  const char letter = info.one_letter_code & ~0x20;
  for (const AminoAcid& a : kAminoAcids)
    if (gemmi::find_tabulated_residue(std::string(a.code)).one_letter_code == letter) return &a;
  return nullptr;
}

int residueCharge_e(std::string_view residue_name) {
  if (const State* state = stateOf(residue_name)) return state->charge_e;
  const AminoAcid* known = byCode(residue_name);
  return known ? known->charge_e : 0;
}

}  // namespace moltact
