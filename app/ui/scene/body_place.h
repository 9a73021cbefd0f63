// Where a body in the hand lies beside the place that it was taken from: how many of its atoms are back, and which are
// stopped. Worked out on the window's thread from the newest tick. Units: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/ui/scene/touchable_model.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// An atom so near to where it was in the molecule's file is back in place.
inline constexpr double kInPlace_A = 1.0;

struct BodyPlace {
  std::size_t atoms = 0;               ///< of the body
  std::size_t in_place = 0;            ///< of them, as the body is drawn
  std::vector<std::uint32_t> stopped;  ///< the body's atoms, by their numbers in it, that the hand presses into others
};

/// Nothing without a body.
BodyPlace bodyPlace(const TouchableModel& stage, const ServoSample& now, const SphereMotion* motion = nullptr);

}  // namespace moltact
