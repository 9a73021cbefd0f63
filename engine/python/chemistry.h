// Element, type and charge of a scene's atoms in Python: the class Chemistry. Invalid input raises ValueError or
// TypeError. The caller holds Python's global lock. Unit: elementary charge.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <string>

#include "engine/haptics/atom_chemistry.h"
#include "engine/haptics/touch_setup.h"
#include "engine/molecule/molecule.h"

namespace moltact::python {

using SharedChemistry = std::shared_ptr<AtomChemistry>;

/// Adds the class to the module.
void addChemistry(pybind11::module_& m);

/// The chemistry of a molecule, with charges from one of chargeSources().
SharedChemistry chemistryOfMolecule(const Molecule& molecule, const std::string& charges);

/// The chemistry for a scene of `atoms` spheres: `given`, whose size must match; else that of a scene that is a
/// Molecule, if the setup needs one; else null.
std::shared_ptr<const AtomChemistry> chemistryOf(const pybind11::object& scene, const SharedChemistry& given,
                                                 const TouchSetup& touch, std::size_t atoms);

}  // namespace moltact::python
