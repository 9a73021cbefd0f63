// What a style needs on the graphics card to draw some atoms of a molecule: made when it is first drawn and kept while
// atoms, colours and probe stay. Needs a current context. Units: angstrom.
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
  /// The same with a surface that has been computed already, of this molecule and this probe.
  StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model, SolventExcluded surface,
             std::shared_ptr<const Molecule> molecule, double probe_A);

  /// Whether it draws a surface, which takes long to compute.
  static bool hasSurface(const StyledAtoms& what, const MoleculeModel& model);
  /// Of each of the model's spheres, whether the style draws it.
  static std::vector<std::uint8_t> shownOf(const StyledAtoms& what, const AtomList& hidden, const MoleculeModel& model);

  /// Whether this is what the scene wants, but perhaps in other colours.
  bool fits(const StyledAtoms& what, const ViewScene& scene) const;
  /// Whether its atoms are the model's, though perhaps in other places.
  bool isOf(const MoleculeModel& model) const {
    return molecule_->id == model.molecule->id && molecule_->atoms.size() == model.molecule->atoms.size() &&
           most_single_atoms_ == model.most_single;
  }
  /// Takes up the model's colours where they have changed.
  void paint(const MoleculeModel& model);

  /// Whether it is the model's own spheres, whatever the style: of a molecule that is drawn by its residues there are no
  /// others.
  bool modelsSpheres() const { return models_spheres_; }
  /// Of each of the model's spheres, whether it is drawn.
  std::span<const std::uint8_t> shown() const { return shown_; }
  const StyledAtoms& what() const { return what_; }
  /// Null where the style has no triangles.
  const GpuMesh* mesh() const { return mesh_.get(); }
  /// Spheres of the style's own size at atoms; empty for Spheres, which have the atoms' radii.
  std::span<const SmallSphere> spheres() const { return spheres_; }
  /// The light among the style's own shapes; null: the molecule's.
  OcclusionVolume* occlusion() { return occlusion_ ? &*occlusion_ : nullptr; }

 private:
  void findShapes(const MoleculeModel& model);

  StyledAtoms what_;
  bool models_spheres_ = false;
  AtomList hidden_;
  std::shared_ptr<const Molecule> molecule_;
  std::size_t most_single_atoms_ = 0;
  double probe_A_ = 0.0;
  unsigned painted_ = 0;
  std::vector<std::uint8_t> shown_;
  std::vector<SmallSphere> spheres_;
  SolventExcluded surface_;  // of a style that uses the probe; its owners are the atoms
  std::unique_ptr<GpuMesh> mesh_;
  std::optional<OcclusionVolume> occlusion_;
};

}  // namespace moltact
