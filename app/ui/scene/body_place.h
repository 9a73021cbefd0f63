// Compares a held body's present position with its position in the molecule's file: how many of its atoms are back.
// Computed on the window's thread from the newest tick. Unit: angstrom.
#pragma once

#include <cstddef>

#include "app/ui/scene/touchable_model.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// An atom within this distance of its position in the file is in place.
inline constexpr double kInPlace_A = 1.0;

struct BodyPlace {
  std::size_t atoms = 0;     ///< number of atoms of the body
  std::size_t in_place = 0;  ///< how many of them are in place, for the body as drawn
};

/// An empty result without a body.
BodyPlace bodyPlace(const TouchableModel& stage, const ServoSample& now);

}  // namespace moltact
