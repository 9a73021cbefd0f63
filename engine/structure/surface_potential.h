// The electrostatic potential of a molecule's charges on its surface. Computed on request, on several threads; pure
// functions, any thread except the haptic one. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/haptics/field/force_choices.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Computes surfacePotential_kcal_mol_e() piece by piece. `molecule` must outlive it.
class SurfacePotential {
 public:
  /// Assigns the charges and sorts the atoms: the part of the work that comes before the pieces.
  SurfacePotential(const Molecule& molecule, const DielectricChoice& medium, std::span<const std::uint32_t> held = {});
  ~SurfacePotential();
  SurfacePotential(const SurfacePotential&) = delete;
  SurfacePotential& operator=(const SurfacePotential&) = delete;

  std::size_t pieces() const;
  /// Computes a piece, 0 to pieces() - 1, once each. Different pieces may run on different threads.
  void compute(std::size_t piece);
  /// The result, when all pieces have been computed.
  std::vector<float> take();

 private:
  class Part;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// For each atom, the mean potential on the part of its sphere, inflated by a water molecule, that no other inflated
/// sphere covers. It is the energy of a charge of 1 e there, in the model of the forces between atoms (PairModel: their
/// charges, medium and cut-off). NaN where the sphere is covered. `held` atoms (ascending) and the others are apart:
/// neither covers nor charges the other.
std::vector<float> surfacePotential_kcal_mol_e(const Molecule& molecule, const DielectricChoice& medium,
                                               std::span<const std::uint32_t> held = {});

/// The end of a symmetric scale for these potentials: 1, 2 or 5 times a power of ten that 95 of 100 do not exceed in
/// amount; 0 if all are 0 or NaN.
double potentialRange_kcal_mol_e(std::span<const float> potentials);

}  // namespace moltact
