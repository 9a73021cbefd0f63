// The haptic shapes of the paper's Figure 9 as lines: inflated spheres, intersection circles and points, cones; and
// the triangles of a mesh method. Pure geometry without graphics calls. Units: angstrom; the output is in the camera's
// axes.
#pragma once

#include <vector>

#include "engine/render/molecule_model.h"
#include "engine/render/sphere_impostors.h"
#include "engine/render/view_scene.h"
#include "engine/render/wireframe.h"

namespace moltact {

/// Adds the shapes that `scene` shows. Of spheres, circles, points and triangles it adds only the parts on the felt
/// surface, and leaves out those inside another inflated sphere. Unless the scene names the atoms, the opacity of
/// spheres and circles decreases with the distance from the SCP (the HIP without contact).
void addHapticShapes(const ViewScene& scene, const MoleculeModel& model, Strokes& strokes,
                     std::vector<LooseSphere>& dots);

/// Adds a full circle about `centre`; `axis` is a unit vector.
void addCircle(Strokes& strokes, const Stroke& stroke, const Camera& camera, const Vec3& centre, const Vec3& axis,
               double radius_A, int pieces = 96);

}  // namespace moltact
