#include "engine/structure/atom_charges.h"

#include <algorithm>
#include <limits>
#include <string>
#include <unordered_map>

#include "engine/haptics/interactions.h"
#include "engine/molecule/elements.h"
#include "engine/structure/amino_acids.h"

namespace moltact {
namespace {

/// The atoms of an amino acid that share the charge of its side chain.
struct ChargedGroup {
  std::string_view code;  ///< of the parent amino acid
  std::string_view atoms[2];
};
constexpr ChargedGroup kSideChains[] = {{"ARG", {"NH1", "NH2"}}, {"ASP", {"OD1", "OD2"}}, {"CYS", {"SG", ""}},
                                        {"GLU", {"OE1", "OE2"}}, {"HIS", {"ND1", "NE2"}}, {"LYS", {"NZ", ""}}};

bool isPhosphateOxygen(std::string_view name) {
  return name == "OP1" || name == "OP2" || name == "O1P" || name == "O2P";
}

/// Shares `charge_e` equally among the atoms of a residue for which `carries` is true.
template <class Carries>
void share(const Molecule& m, const Residue& residue, double charge_e, Carries carries, std::vector<float>& out) {
  const std::uint32_t end = residue.first_atom + residue.atom_count;
  std::size_t carriers = 0;
  for (std::uint32_t i = residue.first_atom; i < end; ++i) carriers += carries(m.atoms[i].nameText());
  for (std::uint32_t i = residue.first_atom; i < end; ++i)
    if (carries(m.atoms[i].nameText())) out[i] = static_cast<float>(charge_e / double(carriers));
}

void setTypes(const Molecule& m, AtomChemistry& out) {
  constexpr std::size_t kMaxNames = std::numeric_limits<std::uint16_t>::max();
  std::unordered_map<std::string, std::uint16_t> known;
  for (const Atom& atom : m.atoms) {
    std::string name = atom.residue == kNoResidue
                           ? std::string(element(atom.atomic_number).symbol)
                           : std::string(m.residues[atom.residue].name) + ' ' + std::string(atom.nameText());
    if (known.size() >= kMaxNames && !known.contains(name)) name.clear();
    const auto [at, added] = known.emplace(name, static_cast<std::uint16_t>(out.type_names.size()));
    if (added) out.type_names.push_back(name);
    out.types.push_back(at->second);
  }
}

}  // namespace

std::vector<float> formalCharges_e(const Molecule& m) {
  std::vector<float> out(m.atoms.size(), 0.0F);
  for (const Residue& residue : m.residues) {
    if (residue.kind == ResidueKind::Nucleotide) share(m, residue, -1.0, isPhosphateOxygen, out);
    const AminoAcid* acid = residue.kind == ResidueKind::AminoAcid ? aminoAcid(residue.name) : nullptr;
    const int charge_e = acid ? residueCharge_e(residue.name) : 0;
    if (charge_e == 0) continue;
    for (const ChargedGroup& group : kSideChains)
      if (group.code == acid->code)
        share(
            m, residue, charge_e,
            [&](std::string_view name) { return !name.empty() && (name == group.atoms[0] || name == group.atoms[1]); },
            out);
  }
  return out;
}

AtomChemistry atomChemistry(const Molecule& m, std::string_view source) {
  AtomChemistry out;
  out.atomic_numbers.reserve(m.atoms.size());
  out.types.reserve(m.atoms.size());
  for (const Atom& atom : m.atoms) out.atomic_numbers.push_back(static_cast<std::uint8_t>(atom.atomic_number));
  setTypes(m, out);
  if (source == kFileCharges) out.charges_e = m.charges_e.copy();
  if (source == kFormalCharges) out.charges_e = formalCharges_e(m);
  return out;
}

std::shared_ptr<const AtomChemistry> chemistryFor(const TouchSetup& touch, const Molecule& molecule) {
  if (!needsChemistry(touch)) return nullptr;
  return std::make_shared<const AtomChemistry>(atomChemistry(molecule, touch.charges));
}

}  // namespace moltact
