// A sphere: one atom in the haptic computation. Units: angstrom.
#pragma once

#include "engine/core/units.h"

namespace moltact {

struct Sphere {
  Vec3 centre_A{0.0};
  double radius_A = 0.0;  ///< van der Waals radius, not inflated by the probe
};

}  // namespace moltact
