// Lengths and angles between places of a molecule, and how they are written. Pure functions; any thread but the haptic
// one. Units: angstrom, degree.
#pragma once

#include <span>
#include <string>

#include "engine/core/units.h"

namespace moltact {

/// At `b`, between the ways to the others, 0 to 180. 0 where two places are one.
double angle_deg(const PointA& a, const PointA& b, const PointA& c);

/// Round the way from `b` to `c`, above -180 to 180: positive where, seen from `b` to `c`, `d` lies clockwise of `a`
/// (IUPAC, Pure Appl. Chem. 40, 291, 1974). 0 where three places lie on a line.
double torsion_deg(const PointA& a, const PointA& b, const PointA& c, const PointA& d);

/// What is measured between two places (a length), three (the angle at the second) or four (the torsion), with its
/// unit; empty for any other number.
std::string measureText(std::span<const PointA> places);

}  // namespace moltact
