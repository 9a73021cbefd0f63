// Places atoms by bond lengths, angles and torsions, as published geometry gives them. Units: angstrom, degree.
#pragma once

#include "engine/core/units.h"

namespace moltact::generator {

double radians(double deg);

/// The place d for which |cd| = length, with the angle bcd and the torsion abcd.
Vec3 placeAtom(Vec3 a, Vec3 b, Vec3 c, double length_A, double angle_deg, double torsion_deg);

}  // namespace moltact::generator
