// The picture of a scan in the molecule: its surface as triangles, those that its tracker feels
// (engine/haptics/height_field), and the tip. Any thread. Unit: angstrom.
#pragma once

#include "engine/haptics/height_field/height_field.h"
#include "engine/render/mesh_piece.h"
#include "engine/render/sphere_impostors.h"
#include "engine/render/view_scene.h"

namespace moltact {

/// The first `lines` lines, in the colours of heightColour(). Without two lines there are no triangles.
MeshPiece reliefOf(const HeightField& field, int lines);

/// Adds the scene's scanning tip, if there is one.
void addScanningTip(const ViewScene& scene, std::vector<LooseSphere>& shell);

}  // namespace moltact
