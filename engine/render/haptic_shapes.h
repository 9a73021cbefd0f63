// The haptic shapes of the paper's Figure 9 as lines: inflated spheres, intersection circles and points, cones.
// Pure geometry; no graphics calls. Units: angstrom; what comes out is in the camera's axes.
#pragma once

#include <vector>

#include "engine/render/molecule_model.h"
#include "engine/render/sphere_impostors.h"
#include "engine/render/view_scene.h"
#include "engine/render/wireframe.h"

namespace moltact {

/// Adds the shapes that `scene` shows. Only what lies on the felt surface is drawn strongly: parts of a sphere or
/// circle inside another inflated sphere are left out. The strength falls off with the distance from the SCP (or the
/// HIP, when free).
void addHapticShapes(const ViewScene& scene, const MoleculeModel& model, Strokes& strokes,
                     std::vector<LooseSphere>& dots);

/// Adds the whole circle about `centre`; `axis` has length 1.
void addCircle(Strokes& strokes, const Stroke& stroke, const Camera& camera, const Vec3& centre, const Vec3& axis,
               double radius_A, int pieces = 96);

}  // namespace moltact
