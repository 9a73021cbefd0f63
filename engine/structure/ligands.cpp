#include "engine/structure/ligands.h"

#include <algorithm>
#include <gemmi/elem.hpp>
#include <gemmi/resinfo.hpp>
#include <string>

#include "engine/molecule/molecule.h"

namespace moltact {

LigandClass ligandClass(std::string_view residue_name) {
  // Haem b, c, a and o, d, siroheme, forms with cobalt, manganese or zinc, and protoporphyrin IX.
  static constexpr std::string_view kHemes[] = {"HEM", "HEC", "HEA", "HAS", "HEB", "HEO", "HDD",
                                                "HDM", "DHE", "SRM", "COH", "MNH", "ZNH", "PP9"};
  if (std::find(std::begin(kHemes), std::end(kHemes), residue_name) != std::end(kHemes)) return LigandClass::Heme;
  static constexpr std::string_view kSugars[] = {"SIA", "NDG", "FUL", "XYP", "XYS", "RIB", "FRU",
                                                 "BDP", "NGA", "A2G", "GLA", "RAM", "AHR", "ARA"};
  if (std::find(std::begin(kSugars), std::end(kSugars), residue_name) != std::end(kSugars)) return LigandClass::Sugar;
  using Kind = decltype(gemmi::ResidueInfo::kind);  // gemmi 0.7 moved the enumeration out of the class
  const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(residue_name));
  if (info.kind == Kind::PYR || info.kind == Kind::KET) return LigandClass::Sugar;
  if (info.kind == Kind::BUF) return LigandClass::Buffer;
  return LigandClass::Other;
}

PolymerPart polymerPart(const Molecule& m, std::uint32_t index) {
  const Atom& atom = m.atoms[index];
  if (atom.residue >= m.residues.size()) return PolymerPart::None;
  const std::string_view name = atom.nameText();
  const auto among = [&](auto... names) { return ((name == names) || ...); };
  switch (m.residues[atom.residue].kind) {
    case ResidueKind::AminoAcid:
      return among("N", "CA", "C", "O", "OXT", "OT1", "OT2", "H", "HN", "HA", "HA2", "HA3", "H1", "H2", "H3", "HXT",
                   "D", "DA", "1HA", "2HA", "HA1")
                 ? PolymerPart::Backbone
                 : PolymerPart::SideChain;
    case ResidueKind::Nucleotide:
      // Atoms of the sugar have a prime, those of the base do not.
      return name.find('\'') != std::string_view::npos || name.find('*') != std::string_view::npos ||
                     among("P", "OP1", "OP2", "OP3", "O1P", "O2P", "O3P", "HOP2", "HOP3")
                 ? PolymerPart::Backbone
                 : PolymerPart::SideChain;
    default:
      return PolymerPart::None;
  }
}

bool isMetal(int atomic_number) {
  return atomic_number > 0 && atomic_number <= 118 && gemmi::is_metal(static_cast<gemmi::El>(atomic_number));
}

}  // namespace moltact
