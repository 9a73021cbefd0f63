// The accessible area of each sphere: the area on which the centre of a probe that rolls over all spheres moves (B. Lee
// and F. M. Richards, J. Mol. Biol. 55, 379, 1971). Computed on request, not in a tick; pure functions, any thread
// except the haptic one. Units: angstrom, square angstrom.
#pragma once

#include <span>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/haptics/contact.h"

namespace moltact {

/// Returns one area per sphere, by the method of A. Shrake and J. A. Rupley (J. Mol. Biol. 79, 351, 1973) with 2000
/// points per sphere. The area of an atom is accurate to some tenths of 1 A2, the sum of a protein to 0.5 %. Of spheres
/// with equal centre and radius the first gets the area.
std::vector<double> accessibleAreas_A2(std::span<const Sphere> spheres, double probe_radius_A = kWaterProbe_A);

/// Returns which spheres the probe can touch, using 500 points per sphere: an area below 0.6 A2 may be missed. Faster
/// than accessibleAreas_A2().
std::vector<bool> accessibleSpheres(std::span<const Sphere> spheres, double probe_radius_A = kWaterProbe_A);

}  // namespace moltact
