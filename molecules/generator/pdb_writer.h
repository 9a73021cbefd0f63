// Writes the generated molecules as PDB text. Unit: angstrom.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/core/units.h"

namespace moltact::generator {

struct MadeAtom {
  std::string name, residue, element;
  char chain = 'A';
  int number = 1;
  Vec3 position_A{0.0};
  bool hetero = false;
};

/// The PDB text: TITLE, the remarks as REMARK 1 lines, the atoms, TER after each chain of a polymer, END.
std::string writePdb(const std::string& title, const std::vector<std::string>& remarks,
                     const std::vector<MadeAtom>& atoms);

std::string makeBDna();
std::string makeAlphaHelix();
/// Chain A: a right-handed helix of L-alanine; chain B: its mirror image, a left-handed helix of D-alanine.
std::string makeHelixPair();
std::string makeBetaStrand();
/// Chain A in front of chain B, back to back.
std::string makeStearicOleic();
std::string makeStearicElaidic();
/// Chain A beside chain B, in contact.
std::string makeStraightNeighbours();
std::string makeKinkedNeighbours();
std::string makeWater();
std::string makeBenzene();
std::string makePentacene();
std::string makeArgon(int atoms);
/// Chain A: one atom; B: two; C: three in a row; D: three in a triangle.
std::string makeArgonShapes();
/// Chain A: two waters with a hydrogen bond between them; chain B: two argon atoms.
std::string makeWaterAndArgon();
/// Chain A: the L form of the amino acid; chain B: its mirror image.
std::string makeAlaninePair();
std::string makePhenylalaninePair();
/// From the text of PDB entry 2HHB: chain 'A' (alpha) or 'B' (beta). Throws if an atom is missing.
std::string makeHaemPocket(const std::string& entry, char chain);
/// From the text of PDB entry 1HPV: only the protein, and only its inhibitor.
std::string makeEmptyProtease(const std::string& entry);
std::string makeAmprenavir(const std::string& entry);
/// From the same text: protein and inhibitor, both flaps turned open by an angle. A model.
std::string makeOpenProtease(const std::string& entry, double angle_deg);
/// The drug stays where it is; isoleucine 84 of both chains becomes valine. A model.
std::string makeResistantProtease(const std::string& entry);
/// The drug in the shut tunnel (chain C), in the open one (F) of the text of 1hpv-open.pdb, and outside (G). A model.
std::string makeThreeHolds(const std::string& entry, const std::string& open);
/// Chain A: a lock; chain B: the key in it. No molecule.
std::string makeKeyAndLock();

/// PQR texts, with charges. Chains A, B, C: an argon atom, a water, acetate; D, E, F: what each pairs with.
std::string makeThreePairs();
/// Chain A: adenine; B: thymine; C: cytosine in the same place, elsewhere.
std::string makeBasePartners();
/// Chains A, B, C: thymine, cytosine, cytosine; D, E, F: adenine, guanine, adenine opposite them.
std::string makeBasePairs();

}  // namespace moltact::generator
