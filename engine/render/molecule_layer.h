// The molecule of a picture with its background, styles and annotation lines, drawn with several samples per pixel and
// cached. It is redrawn only when the camera or the atoms change, so moving the probe costs the same for large and
// small molecules. Needs a current context.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/render/mesh_pass.h"
#include "engine/render/resolve.h"
#include "engine/render/sphere_impostors.h"
#include "engine/render/styled_part.h"
#include "engine/render/surface_jobs.h"
#include "engine/render/view_scene.h"

namespace moltact {

class MoleculeLayer {
 public:
  struct Options {
    int samples = 1;          ///< per pixel, along each edge
    float line_scale = 1.0f;  ///< factor on line widths, which are in pixels of the finished picture
    bool outlines = true, cull = true, fine_light = true;
    bool wait_for_surfaces = true;  ///< false: the previous style stays until surfaces are computed
    friend bool operator==(const Options&, const Options&) = default;
  };
  /// The passes that it uses.
  struct Passes {
    Resolve& background;
    SphereImpostors& spheres;
    MeshPass& meshes;
    Wireframe& wires;
  };

  /// `inside` is the projection of the picture with all its samples. Returns false if the driver refuses the size.
  bool draw(const ViewScene& scene, const MoleculeModel* model, const Projection& inside, const Lighting& lighting,
            const Options& options, Passes passes);

  /// Forces a redraw at the next call.
  void forget() { have_ = false; }

  const GlTarget& target() const { return target_; }
  /// The target that contains the depth of opaque parts, of the same size as target().
  const GlTarget& opaque() const { return faint_ ? opaque_ : target_; }
  /// Progress of surfaces computed in the background; empty if there is none.
  std::optional<float> surfaceProgress() const { return surfaces_.progress(); }
  /// True if the next call will redraw because a surface is ready.
  bool surfaceReady() const { return surfaces_.ready(); }
  /// True if the last call redrew.
  bool redrawn() const { return redrawn_; }
  std::size_t atomsDrawn() const { return atoms_drawn_; }

 private:
  // Everything that determines the picture.
  struct Key {
    std::shared_ptr<const Molecule> molecule;
    std::size_t max_single_atoms = 0;
    unsigned lit = 0;  // MoleculeModel::lit
    ElementColours elements = ElementColours::Customary;
    ColourBy colour_by = ColourBy::Element;
    Camera camera;
    int width = 0, height = 0;
    Options options;
    bool atoms = false;
    Colour top{0.0f}, bottom{0.0f}, tint{0.0f};
    std::vector<std::uint32_t> tinted;
    AtomsLook look;
    AtomList touched;
    std::vector<std::shared_ptr<const Annotations>> annotations;
    double surface_probe_A = 0.0;  // 0: no surface is drawn
    bool operator==(const Key&) const = default;
  };

  void findParts(const ViewScene& scene, const MoleculeModel& model, bool wait);
  void drawPart(StyledPart& part, const ViewScene& scene, const MoleculeModel& model, const Projection& inside,
                const Lighting& lighting, const Options& options, Passes& passes);

  GlTarget target_, opaque_;
  SphereCull cull_;
  std::vector<std::unique_ptr<StyledPart>> parts_;
  SurfaceJobs surfaces_;
  std::vector<LooseSphere> small_;
  Strokes strokes_;
  Key key_;
  bool have_ = false, redrawn_ = false, faint_ = false;
  std::size_t atoms_drawn_ = 0;
};

}  // namespace moltact
