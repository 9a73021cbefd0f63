#include "molecules/generator/made_molecules.h"

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {

std::vector<MadeMolecule> madeMolecules(const std::string& haemoglobin, const std::string& protease) {
  return {
      {"argon.pdb", makeArgon(1)},
      {"argon-pair.pdb", makeArgon(2)},
      {"argon-triangle.pdb", makeArgon(3)},
      {"argon-shapes.pdb", makeArgonShapes()},
      {"water.pdb", makeWater()},
      {"water-and-argon.pdb", makeWaterAndArgon()},
      {"benzene.pdb", makeBenzene()},
      {"pentacene.pdb", makePentacene()},
      {"alanine-pair.pdb", makeAlaninePair()},
      {"phenylalanine-pair.pdb", makePhenylalaninePair()},
      {"stearic-oleic.pdb", makeStearicOleic()},
      {"stearic-elaidic.pdb", makeStearicElaidic()},
      {"straight-neighbours.pdb", makeStraightNeighbours()},
      {"kinked-neighbours.pdb", makeKinkedNeighbours()},
      {"alpha-helix.pdb", makeAlphaHelix()},
      {"helix-pair.pdb", makeHelixPair()},
      {"beta-strand.pdb", makeBetaStrand()},
      {"b-dna.pdb", makeBDna()},
      {"haem-alpha.pdb", makeHaemPocket(haemoglobin, 'A')},
      {"haem-beta.pdb", makeHaemPocket(haemoglobin, 'B')},
      {"1hpv-empty.pdb", makeEmptyProtease(protease)},
      {"amprenavir.pdb", makeAmprenavir(protease)},
      {"1hpv-open.pdb", makeOpenProtease(protease, 24.0)},
      {"1hpv-i84v.pdb", makeResistantProtease(protease)},
      {"1hpv-three-holds.pdb", makeThreeHolds(protease, makeOpenProtease(protease, 24.0))},
      {"key-and-lock.pdb", makeKeyAndLock()},
      {"three-pairs.pqr", makeThreePairs()},
      {"base-partners.pqr", makeBasePartners()},
      {"base-pairs.pqr", makeBasePairs()},
  };
}

}  // namespace moltact::generator
