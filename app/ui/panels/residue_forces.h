// Which residues attract and repel what the hand holds: a list in the touch tab, the glow of their atoms, and the
// hydrogen bonds and clashes of a held body. Nothing is shown where names could give an answer away. Window's thread.
#pragma once

#include "engine/render/view_scene.h"

namespace moltact {

class Application;

/// The residues with the largest energies, at most kListedResidues. Draws nothing where no forces between atoms act.
void drawResidueForces(Application& app);

/// Adds the glow of the listed residues, and the lines between the held body and the molecule, to the picture.
void showForces(const Application& app, ViewScene& scene);

inline constexpr std::size_t kListedResidues = 6;

}  // namespace moltact
