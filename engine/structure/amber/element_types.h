// Lennard-Jones types and charges by element alone, for atoms without a template. Pure functions of the atomic number; any
// thread but the haptic one. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <cstddef>
#include <string_view>

#include "engine/structure/amber/amber.h"

namespace moltact {

/// The AMBER type of an atom with this number of bonded atoms, hydrogen as on a nitrogen. Empty for other elements than H,
/// C, N, O, P and S.
std::string_view elementType(int atomic_number, std::size_t neighbours);

/// The minimum of a pair of atoms of a noble gas, as spectra and transport in the gas give it: R. A. Aziz and co-workers, He
/// 1979, Ne 1989, Ar 1993, Kr 1989, Xe 1986. Argon's is the well that E. A. Colbourn and A. E. Douglas measured (J. Chem.
/// Phys. 65, 1741, 1976): 99.5 /cm deep at 3.76 A. A Lennard-Jones curve has this minimum and is a little too wide. Null
/// for other elements.
const AmberType* nobleGas(int atomic_number);

/// The charge of an ion in water; 0 for an element with several charges or none.
int ionCharge_e(int atomic_number);

}  // namespace moltact
