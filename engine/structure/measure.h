// Lengths and angles between points of a molecule, and their formatting. Pure functions; any thread except the haptic
// one. Units: angstrom, degree.
#pragma once

#include <span>
#include <string>

#include "engine/core/units.h"

namespace moltact {

/// The angle at `b` between the directions to `a` and `c`, 0 to 180. Returns 0 if two points coincide.
double angle_deg(const PointA& a, const PointA& b, const PointA& c);

/// The torsion angle about the line from `b` to `c`, above -180 to 180; positive if, seen from `b` to `c`, `d` is
/// clockwise from `a` (IUPAC, Pure Appl. Chem. 40, 291, 1974). Returns 0 if three points are collinear.
double torsion_deg(const PointA& a, const PointA& b, const PointA& c, const PointA& d);

/// Formats the measure of two points (a length), three (the angle at the second) or four (the torsion) with its unit;
/// empty for any other number.
std::string measureText(std::span<const PointA> places);

}  // namespace moltact
