// Exports a molecule as a glTF scene, for slides, web pages and 3D printing. Pure function; not for the haptic thread.
// One unit of the file is 1 nm (times the scale); y is up; the origin is the middle of the molecule's bounding box.
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
  /// Styles, hidden atoms and colouring, as in a picture; spheres are grouped by chain and may overlap.
  AtomsLook look = {};
  /// Hydrogen bonds and measures, as dashed sticks; the name of a measure is its value. Labels are omitted, because the
  /// file contains no text. Ignored with `print`.
  std::vector<std::shared_ptr<const Annotations>> annotations = {};
  std::vector<std::uint32_t> highlighted = {};  ///< atoms in the colour of targets; indices out of range are ignored
  bool print = false;  ///< for 3D printing: one closed surface in the atoms' colours, instead of the styles
  /// Spheres and the surface for printing are inflated by this radius. 1.4 gives the solvent-accessible surface.
  /// The style Surface uses a probe of the same radius; with 0, that of water.
  double probe_A = 0.0;
  double step_A = 0.0;  ///< resolution of the surface for printing; 0: chosen by the molecule's size
  double units_per_nm = 1.0;
  ElementColours colours = ElementColours::Customary;
  ColourBy colour_by = ColourBy::Element;
};

/// Returns a Problem if no atom is shown, or if the surface is too fine for the memory.
Expected<GltfScene> exportMolecule(const Molecule& molecule, const ExportOptions& options);

/// A sphere of radius 1 made of 1280 triangles, with all vertices on the sphere.
GltfMesh sphereMesh();

}  // namespace moltact
