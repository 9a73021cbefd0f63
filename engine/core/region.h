// A part of a molecule that is enlarged for the hand. Plain data; any thread. Units: angstrom.
#pragma once

#include "engine/core/units.h"

namespace moltact {

/// A sphere in the molecule's space.
struct Region {
  PointA centre;
  double radius_A = 0.0;
};

}  // namespace moltact
