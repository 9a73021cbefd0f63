// A molecule as a glTF scene, for slides, web pages and printing. Pure function; not for the haptic thread.
// 1 unit of the file is 1 nm (times the scale); y is up; the middle of the molecule's box is the origin.
#pragma once

#include "engine/gltf/gltf_file.h"
#include "engine/molecule/molecule.h"
#include "engine/render/atom_style.h"

namespace moltact {

enum class ExportStyle {
  Balls,    ///< one ball an atom in its element's colour, grouped by chain; balls reach into each other
  Surface,  ///< one closed surface, coloured by the atoms it lies on: for printing
};

struct ExportOptions {
  ExportStyle style = ExportStyle::Balls;
  double probe_A = 0.0;  ///< every atom is inflated by this: 1.4 gives the surface that a water molecule feels
  double step_A = 0.0;   ///< fineness of the surface; 0: by the molecule's size
  double units_per_nm = 1.0;
  ElementColours colours = ElementColours::Customary;
};

/// A molecule without atoms, or a surface so fine that it would not fit in memory, gives a problem.
Expected<GltfScene> exportMolecule(const Molecule& molecule, const ExportOptions& options);

/// A ball of radius 1 as 1280 triangles whose corners lie on it.
GltfMesh ballMesh();

}  // namespace moltact
