// What may stand for the hand in the view: the tip is the origin, the body lies along +y. 1 unit is 1 m.
#pragma once

#include "engine/gltf/gltf_file.h"

namespace moltact::generator {

/// The pen of a haptic device, 11 cm long.
GltfScene makeStylus();

}  // namespace moltact::generator
