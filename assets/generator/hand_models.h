// Models that represent the hand in the view. The tip is at the origin, the body extends along +y. Unit: metre.
#pragma once

#include "engine/gltf/gltf_file.h"

namespace moltact::generator {

/// The pen of a haptic device, 11 cm long.
GltfScene makeStylus();

}  // namespace moltact::generator
