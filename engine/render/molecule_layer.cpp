#include "engine/render/molecule_layer.h"

#include <algorithm>

namespace moltact {
namespace {

// The width of the dark rims at depth 1: 1.3 pixels of the finished picture.
float rimOf(int samples, const Projection& inside) {
  return 1.3f * float(samples) * 2.0f * inside.tan_y / float(inside.height_px);
}

}  // namespace

// Keeps matching parts and creates new ones. While a surface is computed all parts are kept; if there are none of this
// molecule, spheres replace the surface.
void MoleculeLayer::findParts(const ViewScene& scene, const MoleculeModel& model, bool wait) {
  std::vector<StyledAtoms> wanted = scene.look.styles;
  if (wanted.empty()) wanted.emplace_back();
  const auto partFor = [&](const StyledAtoms& what) {
    return std::find_if(parts_.begin(), parts_.end(), [&](const auto& p) { return p && p->fits(what, scene); });
  };
  std::vector<std::unique_ptr<StyledPart>> made(wanted.size());
  bool missing = false;
  surfaces_.beginPicture();
  for (std::size_t k = 0; !wait && k < wanted.size(); ++k) {
    if (!StyledPart::hasSurface(wanted[k], model) || partFor(wanted[k]) != parts_.end()) continue;
    if (auto surface = surfaces_.take(wanted[k], scene, model))
      made[k] = std::make_unique<StyledPart>(wanted[k], scene, model, std::move(surface->surface),
                                             std::move(surface->molecule), surface->probe_A);
    else
      missing = true;
  }
  surfaces_.endPicture();
  if (missing && !parts_.empty() && parts_.front()->isOf(model)) {
    for (const auto& part : parts_) part->paint(model);
    return;
  }
  std::vector<std::unique_ptr<StyledPart>> parts;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto at = partFor(wanted[k]);
    StyledAtoms what = wanted[k];
    if (at == parts_.end() && !made[k] && !wait && StyledPart::hasSurface(what, model)) what.style = DrawStyle::Spheres;
    parts.push_back(made[k]              ? std::move(made[k])
                    : at != parts_.end() ? std::move(*at)
                                         : std::make_unique<StyledPart>(what, scene, model));
    parts.back()->paint(model);
  }
  parts_ = std::move(parts);
}

void MoleculeLayer::drawPart(StyledPart& part, const ViewScene& scene, const MoleculeModel& model,
                             const Projection& inside, const Lighting& lighting, const Options& options,
                             Passes& passes) {
  const float opacity = part.what().opacity;
  if (part.modelsSpheres()) {
    const float rim = options.outlines && opacity >= 1.0f ? rimOf(options.samples, inside) : 0.0f;
    // A cut reveals what it has hidden.
    cull_.run(model.spheres, model.blocks, scene.camera, inside, rim,
              options.cull && !scene.look.cut && opacity >= 1.0f, part.shown());
    atoms_drawn_ += cull_.atomsDrawn();
    passes.spheres.drawMolecule(model, cull_.drawn(), key_.tinted, packColour(key_.tint), rim, opacity, inside,
                                lighting);
    return;
  }
  Lighting among = lighting;
  if (part.occlusion()) among.occlusion = part.occlusion();
  if (part.mesh()) passes.meshes.draw(*part.mesh(), opacity, inside, among);
  small_.clear();
  for (const SmallSphere& b : part.spheres()) {
    const bool marked = std::binary_search(key_.tinted.begin(), key_.tinted.end(), b.atom);
    const std::uint32_t colour = marked ? packColour(key_.tint) : model.colour[b.atom];
    small_.push_back({glm::vec3(scene.camera.toView({model.spheres[b.atom].centre_A})), b.radius_A,
                      (colour & 0x00FFFFFFu) | (packColour({}, opacity) & 0xFF000000u), b.wide});
  }
  passes.spheres.drawLoose(small_, opacity < 1.0f ? SphereImpostors::Pass::Faint : SphereImpostors::Pass::Solid, inside,
                           among);
}

bool MoleculeLayer::draw(const ViewScene& scene, const MoleculeModel* model, const Projection& inside,
                         const Lighting& lighting, const Options& options, Passes passes) {
  Key key{.molecule = scene.molecule,
          .max_single_atoms = scene.max_single_atoms,
          .lit = model ? model->lit : 0,
          .elements = scene.elements,
          .colour_by = scene.colour_by,
          .camera = scene.camera,
          .width = inside.width_px,
          .height = inside.height_px,
          .options = options,
          .atoms = scene.shown.has(ViewPart::Atoms),
          .top = scene.theme.background_top,
          .bottom = scene.theme.background_bottom,
          .tint = scene.theme.target,
          .tinted = {},
          .look = scene.look,
          .touched = scene.touched,
          .annotations = scene.annotations,
          .surface_probe_A = 0.0};
  key.look.spheres_near_A = 0.0;  // these spheres are drawn with the glyphs
  for (const StyledAtoms& s : scene.look.styles)
    if (infoOf(s.style).uses_probe && !(model && model->byResidue())) key.surface_probe_A = scene.probe_A;
  if (scene.shown.has(ViewPart::Target)) key.tinted = scene.highlighted;
  std::sort(key.tinted.begin(), key.tinted.end());
  if (model) key.tinted = model->spheresOf(std::move(key.tinted));
  redrawn_ = !(have_ && key == key_) || surfaces_.ready();
  if (!redrawn_) return true;
  have_ = false;
  if (!target_.resize(inside.width_px, inside.height_px)) return false;
  key_ = std::move(key);
  if (model && key_.atoms) {
    findParts(scene, *model, options.wait_for_surfaces);
  } else {
    parts_.clear();
    surfaces_.beginPicture();
    surfaces_.endPicture();
  }
  target_.bind();
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  passes.background.background(lighting);
  atoms_drawn_ = 0;
  for (const auto& part : parts_)
    if (part->what().opacity >= 1.0f) drawPart(*part, scene, *model, inside, lighting, options, passes);
  // Transparent parts cover what is behind them but do not hide the probe.
  faint_ = std::any_of(parts_.begin(), parts_.end(), [](const auto& p) { return p->what().opacity < 1.0f; });
  if (faint_) {
    if (!opaque_.resize(inside.width_px, inside.height_px)) return false;
    copyPart(target_, opaque_, {0, 0, inside.width_px, inside.height_px}, GL_DEPTH_BUFFER_BIT);
    target_.bind();
    for (const auto& part : parts_)
      if (part->what().opacity < 1.0f) drawPart(*part, scene, *model, inside, lighting, options, passes);
  }
  strokes_.clear();
  for (const auto& annotations : scene.annotations) addLines(*annotations, scene.camera, scene.theme, strokes_);
  passes.wires.draw(strokes_, inside, options.line_scale * float(options.samples));
  have_ = true;
  return true;
}

}  // namespace moltact
