// How much of each sphere a probe that rolls over all of them can touch: the accessible area of B. Lee and F. M. Richards
// (J. Mol. Biol. 55, 379, 1971), which is the area that the probe's centre moves on. Worked out when it is asked for, at
// a person's pace; pure functions, any thread but the haptic one. Units: angstrom, square angstrom.
#pragma once

#include <span>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/haptics/contact.h"

namespace moltact {

/// One area for each sphere, by the points of A. Shrake and J. A. Rupley (J. Mol. Biol. 79, 351, 1973): 2000 on each
/// sphere, so that the area of an atom is known to some tenths of 1 A2 and the sum of a protein's to less than 0.5 %. Of
/// spheres with the same centre and radius the first has the area.
std::vector<double> accessibleAreas_A2(std::span<const Sphere> spheres, double probe_radius_A = kWaterProbe_A);

/// Which spheres the probe can touch at all, as far as 500 points on each tell: an area of less than 0.6 A2 may be missed.
/// Quicker than their areas.
std::vector<bool> accessibleSpheres(std::span<const Sphere> spheres, double probe_radius_A = kWaterProbe_A);

}  // namespace moltact
