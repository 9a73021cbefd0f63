// The data on the graphics card for drawing atoms in one style. Created when first drawn and kept while atoms, colours
// and probe are unchanged. Needs a current context. Units: angstrom.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/render/mesh_pass.h"
#include "engine/render/molecule_model.h"
#include "engine/render/solvent_excluded.h"
#include "engine/render/style_shapes.h"
#include "engine/render/view_scene.h"

namespace moltact {

class StyledPart {
 public:
  StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model);
  /// The same with a surface that was computed before for this molecule and probe.
  StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model, SolventExcluded surface,
             std::shared_ptr<const Molecule> molecule, double probe_A);

  /// True if the style draws a surface, which takes long to compute.
  static bool hasSurface(const StyledAtoms& what, const MoleculeModel& model);
  /// One flag per sphere of the model: nonzero if the style draws it.
  static std::vector<std::uint8_t> shownOf(const StyledAtoms& what, const AtomList& hidden, const MoleculeModel& model);

  /// True if this part matches the scene, except possibly for colours.
  bool fits(const StyledAtoms& what, const ViewScene& scene) const;
  /// True if its atoms are those of the model, possibly at other positions.
  bool isOf(const MoleculeModel& model) const {
    return molecule_->sameTopology(*model.molecule) && max_single_atoms_ == model.max_single;
  }
  /// Adopts the model's colours if they have changed.
  void paint(const MoleculeModel& model);

  /// True if the part draws the model's own spheres. Molecules drawn by residues have no others in any style.
  bool modelsSpheres() const { return models_spheres_; }
  /// One flag per sphere of the model: nonzero if it is drawn.
  std::span<const std::uint8_t> shown() const { return shown_; }
  const StyledAtoms& what() const { return what_; }
  /// Null for a style without triangles.
  const GpuMesh* mesh() const { return mesh_.get(); }
  /// Spheres at atoms with the style's own radius; empty for Spheres, which uses the atoms' radii.
  std::span<const SmallSphere> spheres() const { return spheres_; }
  /// The ambient occlusion of the style's own shapes; null: that of the molecule.
  OcclusionVolume* occlusion() { return occlusion_ ? &*occlusion_ : nullptr; }

 private:
  void findShapes(const MoleculeModel& model);

  StyledAtoms what_;
  bool models_spheres_ = false;
  AtomList hidden_;
  std::shared_ptr<const Molecule> molecule_;
  std::size_t max_single_atoms_ = 0;
  double probe_A_ = 0.0;
  unsigned painted_ = 0;
  std::vector<std::uint8_t> shown_;
  std::vector<SmallSphere> spheres_;
  SolventExcluded surface_;  // for a style that uses the probe; its owners are the atoms
  std::unique_ptr<GpuMesh> mesh_;
  std::optional<OcclusionVolume> occlusion_;
};

}  // namespace moltact
