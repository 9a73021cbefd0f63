#include "engine/structure/roughness.h"

#include "engine/haptics/texture_choices.h"
#include "engine/structure/amino_acids.h"

namespace moltact {
namespace {

constexpr double kMaxHydropathy = 4.5;  // the largest amount on the scale of Kyte and Doolittle
constexpr float kSpread = 0.75f;        // the most that a property adds to or takes from 1

float ofElement(int atomic_number) {
  switch (atomic_number) {
    case 1:
      return 0.75f;
    case 7:
    case 15:
      return 1.5f;
    case 8:
      return 1.0f + kSpread;
    case 16:
      return 0.5f;
    default:
      return 1.0f;
  }
}

float ofHydropathy(const Residue& r) {
  const AminoAcid* a = r.kind == ResidueKind::AminoAcid ? aminoAcid(r.name) : nullptr;
  return a ? 1.0f - kSpread * float(a->hydropathy / kMaxHydropathy) : 1.0f;
}

// As the colouring `charge` shows it: of the side chain of an amino acid and of the phosphate of a nucleotide.
float ofCharge(const Residue& r, std::string_view atom) {
  int charge = 0;
  if (r.kind == ResidueKind::AminoAcid && atom != "N" && atom != "CA" && atom != "C" && atom != "O")
    charge = residueCharge_e(r.name);
  if (r.kind == ResidueKind::Nucleotide &&
      (atom == "P" || atom == "OP1" || atom == "OP2" || atom == "O1P" || atom == "O2P"))
    charge = -1;
  return 1.0f + kSpread * float((charge > 0) - (charge < 0));
}

}  // namespace

std::shared_ptr<const Roughness> roughness(const Molecule& molecule, std::string_view texture) {
  const bool element = texture == kElementTexture, hydropathy = texture == kHydrophobicityTexture;
  if (!element && !hydropathy && texture != kChargeTexture) return nullptr;
  auto out = std::make_shared<Roughness>();
  out->reserve(molecule.atoms.size());
  for (const Atom& a : molecule.atoms) {
    if (element)
      out->push_back(ofElement(a.atomic_number));
    else if (a.residue == kNoResidue)
      out->push_back(1.0f);
    else
      out->push_back(hydropathy ? ofHydropathy(molecule.residues[a.residue])
                                : ofCharge(molecule.residues[a.residue], a.nameText()));
  }
  return out;
}

}  // namespace moltact
