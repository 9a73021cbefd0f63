// A molecule as a glTF scene, for slides, web pages and printing. Pure function; not for the haptic thread.
// 1 unit of the file is 1 nm (times the scale); y is up; the middle of the molecule's box is the origin.
#pragma once

#include <memory>
#include <vector>

#include "engine/gltf/gltf_file.h"
#include "engine/molecule/molecule.h"
#include "engine/render/annotations.h"
#include "engine/render/atom_style.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct ExportOptions {
  AtomsLook look =
      {};  ///< styles, what is hidden, and a colouring, as a picture has them; spheres are grouped by chain and
           ///< reach into each other
  std::vector<std::shared_ptr<const Annotations>> annotations =
      {};  ///< hydrogen bonds and measures as dashed sticks, each measure with its value for a name; the names of a picture
           ///< are left out: the file holds no letters. None of it is printed
  std::vector<std::uint32_t> highlighted = {};  ///< atoms in the colour of targets; out-of-range ones are ignored
  bool print = false;  ///< in the styles' place one closed surface, coloured by the atoms it lies on: for printing
  double probe_A =
      0.0;  ///< spheres, and the surface for printing, are inflated by this: 1.4 gives what a water molecule
            ///< feels; the style Surface is the one that such a probe can reach (0: that of water)
  double step_A = 0.0;  ///< fineness of the surface for printing; 0: by the molecule's size
  double units_per_nm = 1.0;
  ElementColours colours = ElementColours::Customary;
  ColourBy colour_by = ColourBy::Element;
};

/// A molecule of which no atom is shown, or a surface so fine that it would not fit in memory, gives a problem.
Expected<GltfScene> exportMolecule(const Molecule& molecule, const ExportOptions& options);

/// A sphere of radius 1 as 1280 triangles whose corners lie on it.
GltfMesh sphereMesh();

}  // namespace moltact
