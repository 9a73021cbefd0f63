// The molecule of a picture on its background, in its styles, with the lines that are drawn into it, drawn with several samples for each pixel and kept: it is
// drawn again only when the camera or the atoms change, so that moving the probe over a large molecule costs no more than
// over a small one. Needs a current context.
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
    int samples = 1;          ///< along each pixel's edge
    float line_scale = 1.0f;  ///< multiplies the widths of lines, in pixels of the finished picture
    bool outlines = true, cull = true, fine_light = true;
    bool wait_for_surfaces = true;  ///< else the former style stays until they are computed
    friend bool operator==(const Options&, const Options&) = default;
  };
  /// What it draws with.
  struct Passes {
    Resolve& background;
    SphereImpostors& spheres;
    MeshPass& meshes;
    Wireframe& wires;
  };

  /// `inside` is the projection of a picture with all its samples. Returns false where the driver refuses the size.
  bool draw(const ViewScene& scene, const MoleculeModel* model, const Projection& inside, const Lighting& lighting,
            const Options& options, Passes passes);

  /// Draws again at the next call.
  void forget() { have_ = false; }

  const GlTarget& target() const { return target_; }
  /// Holds the depth of what is opaque, as large as target().
  const GlTarget& opaque() const { return faint_ ? opaque_ : target_; }
  /// Of the surfaces that are computed beside the window; no value where there is none to wait for.
  std::optional<float> surfaceProgress() const { return surfaces_.progress(); }
  /// Whether the next call will draw because a surface is there.
  bool surfaceReady() const { return surfaces_.ready(); }
  /// Whether the last call drew.
  bool redrawn() const { return redrawn_; }
  std::size_t atomsDrawn() const { return atoms_drawn_; }

 private:
  // All that the picture depends on.
  struct Key {
    std::shared_ptr<const Molecule> molecule;
    std::size_t most_single_atoms = 0;
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
    double surface_probe_A = 0.0;  // 0 where no surface is drawn
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
