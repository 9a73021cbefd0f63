#include "engine/structure/amber/charge_faults.h"

#include <cmath>
#include <set>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {

std::string chargeFaults(const PairAtoms& assigned) {
  using Kind = PairAtoms::Note::Kind;
  std::set<std::uint32_t> unknown, without, incomplete;
  bool fractional = false;
  for (const PairAtoms::Note& note : assigned.notes) {
    if (note.kind == Kind::UnknownElement) unknown.insert(note.residue);
    if (note.kind == Kind::NoTemplate && !assigned.file_charges) without.insert(note.residue);
    if ((note.kind == Kind::OtherAtoms || note.kind == Kind::MissingAtoms) && !assigned.file_charges)
      incomplete.insert(note.residue);
    fractional = fractional || note.kind == Kind::FractionalCharge;
  }
  std::vector<std::string> parts;
  if (!unknown.empty())
    parts.push_back(trnf("{0} residue has atoms of unknown elements", "{0} residues have atoms of unknown elements",
                         unknown.size(), unknown.size()));
  if (fractional)
    parts.push_back(trf("the net charge is {0} e from a whole number",
                        quantityNumber(std::abs(assigned.net_charge_e - std::round(assigned.net_charge_e)),
                                       Dimension::None, decimals(2))));
  if (!without.empty())
    parts.push_back(trnf("{0} residue has no charges", "{0} residues have no charges", without.size(), without.size()));
  if (!incomplete.empty())
    parts.push_back(trnf("{0} residue lacks charges of some atoms", "{0} residues lack charges of some atoms",
                         incomplete.size(), incomplete.size()));
  if (parts.empty()) return {};
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : "; ") + part;
  return trf("Forces between atoms: {0}. 'moltact info --charges' names the residues.", all);
}

}  // namespace moltact
