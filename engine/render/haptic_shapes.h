// The haptic shapes of the paper's Figure 9 as lines: inflated spheres, intersection circles and points, cones. Pure
// geometry without graphics calls. Units: angstrom; the output is in the camera's axes.
#pragma once

#include <vector>

#include "engine/render/molecule_model.h"
#include "engine/render/sphere_impostors.h"
#include "engine/render/view_scene.h"
#include "engine/render/wireframe.h"

namespace moltact {

/// Adds the shapes that `scene` shows. Only parts on the felt surface are emphasized: parts of a sphere or circle
/// inside another inflated sphere are omitted. The opacity decreases with the distance from the SCP (or the HIP, when
/// free).
void addHapticShapes(const ViewScene& scene, const MoleculeModel& model, Strokes& strokes,
                     std::vector<LooseSphere>& dots);

/// Adds a full circle about `centre`; `axis` is a unit vector.
void addCircle(Strokes& strokes, const Stroke& stroke, const Camera& camera, const Vec3& centre, const Vec3& axis,
               double radius_A, int pieces = 96);

}  // namespace moltact
