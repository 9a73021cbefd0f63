// What may stand for the hand in the view: the tip is the origin, the body lies along +y, a finger's nail faces +z.
// 1 unit is 1 m.
#pragma once

#include "engine/gltf/gltf_file.h"

namespace moltact::generator {

/// The pen of a haptic device, 11 cm long.
GltfScene makeStylus();
/// The last two joints of a forefinger, of no one's skin.
GltfScene makeFinger();

}  // namespace moltact::generator
