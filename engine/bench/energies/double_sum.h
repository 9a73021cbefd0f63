// The direct sum of PairSum in double precision and plain code: the oracle of energies, and with a cut-off and lists of
// neighbours a method to be measured. In Mehler and Solmajer's dielectric only. Units: angstrom, kcal/mol.
#pragma once

#include <memory>
#include <vector>

#include "engine/haptics/field/pair_sum.h"

namespace moltact::bench {

class DoubleSum {
 public:
  /// Without lists it sums over all atoms of the scene; `cutoff_A` infinite: no cut-off.
  DoubleSum(std::shared_ptr<const SphereGrid> scene, std::vector<PairAtom> atoms, std::vector<PairAtom> body,
            double cutoff_A, bool lists);

  /// With the meaning of PairSum::at, except that the curvature is not computed.
  PairEnergy at(const PoseA& pose);
  std::size_t bytes() const;

 private:
  void add(PairTerms& out, const PairAtom& own, const Vec3& place, const PairAtom& other) const;

  std::shared_ptr<const SphereGrid> scene_;
  std::vector<PairAtom> atoms_, body_;
  double cut2_, from2_, reach_A_;
  bool lists_;
  struct Near {
    Vec3 centre_A{1e300};
    std::vector<PairAtom> atoms;
  };
  std::vector<Near> near_;
};

}  // namespace moltact::bench
