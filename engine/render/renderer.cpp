#include "engine/render/renderer.h"

#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/platform/background.h"
#include "engine/render/contact_shadow.h"
#include "engine/render/edge_filter.h"
#include "engine/render/glyphs.h"
#include "engine/render/haptic_shapes.h"
#include "engine/render/molecule_layer.h"
#include "engine/render/pixel_box.h"
#include "engine/render/relief.h"
#include "engine/render/resolve.h"
#include "engine/render/solid_mesh.h"

namespace moltact {
namespace {

// Depth range around the molecule for the probe, the arrow and the HIP.
constexpr double kRoom_A = 30.0;
// A cartoon's ribbons and names of atoms may extend this far beyond the spheres.
constexpr double kBeyondSpheres_A = 4.0;
constexpr float kReliefOpacity = 0.6f;

DepthRange depthRange(const Camera& camera, const MoleculeModel* model) {
  const PointA middle{model ? model->middle_A : camera.target.A};
  const double reach = (model ? model->reach_A : 0.0) + kRoom_A, depth = -camera.toView(middle).z;
  DepthRange range;
  range.near_A = std::max({depth - reach, 0.02 * camera.distance_A, 0.05});
  range.far_A = std::max(depth + reach, 2.0 * range.near_A);
  return range;
}

Lighting lightingOf(const ViewScene& scene, const MoleculeModel* model, OcclusionVolume* occlusion,
                    const DepthRange& range) {
  Lighting lighting;
  lighting.occlusion = occlusion;
  lighting.camera = scene.camera;
  lighting.background_top = scene.theme.background_top;
  lighting.background_bottom = scene.theme.background_bottom;
  if (scene.look.cut) {
    const Vec3 normal = glm::conjugate(scene.camera.orientation) * scene.look.cut->normal;
    const double beyond = glm::dot(scene.look.cut->normal, scene.camera.eye().A) - scene.look.cut->offset_A;
    lighting.cut = glm::vec4(glm::vec3(normal), float(beyond));
  }
  if (model && model->reach_A > 0) {
    const double depth = -scene.camera.toView({model->middle_A}).z;
    const double front = std::max(depth - model->reach_A, range.near_A), back = depth + model->reach_A;
    lighting.fade_from_A = float(front + 0.25 * (back - front));
    lighting.fade_over_A = float(std::max(1e-3, 0.75 * (back - front)));
    lighting.max_fade = float(scene.theme.fade * std::clamp((back - front) / 40.0, 0.15, 1.0));
  }
  return lighting;
}

// Restores the caller's state at the end of a picture, in any case.
class CallersState {
 public:
  CallersState() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
    glGetIntegerv(GL_SCISSOR_BOX, box_);
    scissor_ = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  }
  ~CallersState() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glScissor(box_[0], box_[1], box_[2], box_[3]);
    scissor_ ? glEnable(GL_SCISSOR_TEST) : glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }

 private:
  GLint draw_ = 0, read_ = 0, viewport_[4]{}, box_[4]{};
  GLboolean scissor_ = GL_FALSE;
};

}  // namespace

struct Renderer::Impl {
  Impl(SphereImpostors b, Wireframe w, SolidMesh m, MeshPass p, Resolve r, ContactShadow c, EdgeFilter e)
      : spheres(std::move(b)),
        wires(std::move(w)),
        mesh(std::move(m)),
        meshes(std::move(p)),
        resolve(std::move(r)),
        shadow(std::move(c)),
        filter(std::move(e)) {}

  SphereImpostors spheres;
  Wireframe wires;
  SolidMesh mesh;   // of the glyphs, rebuilt for each picture
  MeshPass meshes;  // of the molecule, cached
  Resolve resolve;
  ContactShadow shadow;
  EdgeFilter filter;
  MoleculeLayer layer;
  GlTarget flat;     // the layer at the picture's size
  GlTarget large;    // the part of the layer on which glyphs are drawn, with all samples
  GlTarget picture;  // the complete picture
  GlTarget smooth;   // the same with filtered edges, for one sample per pixel
  bool filtered = false;
  PixelBox glyph_box;  // of the glyphs in the last picture
  std::unique_ptr<MoleculeModel> model;
  OcclusionVolume occlusion;
  NewestWork<MoleculeLight> light;  // computed in the background while atoms move
  bool light_is_old = false;        // the atoms have moved since it was started
  Glyphs glyphs;
  std::shared_ptr<const MeshPiece> relief;  // of the last picture, and on the graphics card
  std::unique_ptr<GpuMesh> relief_mesh;
  std::vector<LooseSphere> dots, near;  // of the haptic shapes; the atoms near the probe
  ViewScene last;
  RenderOptions last_options;
  bool have_picture = false;
  RenderCount count;

  void forget() {
    layer.forget();
    have_picture = false;
  }
  void findLight(const ViewScene& scene, bool at_once, bool moved);
  void smoothEdges(const PixelBox& changed, bool all, const ViewScene& scene, const Projection& projection);
  const GlTarget& shown() const { return filtered ? smooth : picture; }
  bool drawScene(const ViewScene& scene, int width_px, int height_px, const RenderOptions& options);
  void drawGlyphs(const GlTarget& on, const Projection& projection, const Lighting& lighting, float line_scale);
  void addRelief(const ViewScene& scene, PixelBoxBuilder& around);
};

// Computes the light immediately for another molecule; for moving atoms in the background, keeping the last one
// meanwhile.
void Renderer::Impl::findLight(const ViewScene& scene, bool at_once, bool moved) {
  light_is_old = light_is_old || moved;
  if (!model || at_once) {
    light.drop();
    light_is_old = false;
    if (!model) return;
    model->hidden = scene.look.hidden;
    model->lightBy(lightAmong(model->spheres, model->shownWithout(model->hidden)));
    occlusion.upload(model->light.field);
  } else if (std::optional<MoleculeLight> found = light.take()) {
    model->lightBy(*std::move(found));
    occlusion.upload(model->light.field);
  }
  if (light_is_old && !light.busy()) {
    light.begin(inBackground(lightAmong, model->spheres, model->shownWithout(model->hidden)));
    light_is_old = false;
  }
}

Renderer::Renderer() = default;
Renderer::~Renderer() = default;

Expected<std::unique_ptr<Renderer>> Renderer::create() {
  if (const int version = tooOldGl())
    return Problem{.file = {},
                   .message = trf("the graphics driver offers OpenGL {0}.{1}", version / 10, version % 10),
                   .remedy = tr("OpenGL 3.3 is needed; LIBGL_ALWAYS_SOFTWARE=1 uses the software driver")};
  auto spheres = SphereImpostors::build();
  if (!spheres) return spheres.problem();
  auto wires = Wireframe::build();
  if (!wires) return wires.problem();
  auto mesh = SolidMesh::build();
  if (!mesh) return mesh.problem();
  auto meshes = MeshPass::build();
  if (!meshes) return meshes.problem();
  auto resolve = Resolve::build();
  if (!resolve) return resolve.problem();
  auto shadow = ContactShadow::build();
  if (!shadow) return shadow.problem();
  auto filter = EdgeFilter::build();
  if (!filter) return filter.problem();
  std::unique_ptr<Renderer> made(new Renderer);
  made->impl_ = std::make_unique<Impl>(*std::move(spheres), *std::move(wires), *std::move(mesh), *std::move(meshes),
                                       *std::move(resolve), *std::move(shadow), *std::move(filter));
  return {std::move(made)};
}

void Renderer::Impl::drawGlyphs(const GlTarget& on, const Projection& projection, const Lighting& lighting,
                                float line_scale) {
  spheres.drawLoose(near, SphereImpostors::Pass::Solid, projection, lighting);
  if (glyphs.shadow_radius > 0) shadow.draw(on, glyphs.shadow_centre, glyphs.shadow_radius, projection);
  // Ghosts first: they appear only behind atoms, and the solid bodies of the glyphs must not count as hiding them.
  Lighting own = lighting;
  own.max_fade *= 0.4f;  // keeps glyphs and targets visible at a distance
  own.occlusion = nullptr;
  own.cut = Lighting().cut;
  spheres.drawLoose(glyphs.ghost, SphereImpostors::Pass::Ghost, projection, own);
  for (const GlyphCone& c : glyphs.cones) mesh.addCone(c.a, c.b, c.radius_a, c.radius_b, c.colour);
  for (const GlyphModel& m : glyphs.models) mesh.addModel(*m.model, m.to_view);
  mesh.draw(projection, own, 0.35f);
  spheres.drawLoose(glyphs.solid, SphereImpostors::Pass::Solid, projection, own);
  spheres.drawLoose(dots, SphereImpostors::Pass::Solid, projection, own);
  wires.draw(glyphs.strokes, projection, line_scale);
  spheres.drawLoose(glyphs.shell, SphereImpostors::Pass::Shell, projection, own);
  // Last, because it hides what is drawn under it afterwards.
  if (relief_mesh) meshes.draw(*relief_mesh, kReliefOpacity, projection, own);
}

// Uploads the scanned surface, if it is another one, and adds its extent.
void Renderer::Impl::addRelief(const ViewScene& scene, PixelBoxBuilder& around) {
  if (scene.relief != relief) {
    relief = scene.relief;
    relief_mesh = relief && !relief->indices.empty() ? std::make_unique<GpuMesh>(*relief) : nullptr;
  }
  if (!relief_mesh) return;
  float reach = 0.0f;
  for (const MeshPiece::Vertex& v : relief->vertices) reach = std::max(reach, glm::length(v.place));
  around.add(glm::vec3(scene.camera.toView({relief->origin_A})), reach);
}

// The molecule is drawn with samples x samples per pixel and cached. The glyphs are drawn on the part that they cover,
// with as many samples, and only that part is downsampled again.
bool Renderer::Impl::drawScene(const ViewScene& scene, int width_px, int height_px, const RenderOptions& options) {
  const int samples = std::clamp(options.samples, 1, 4);
  const Projection projection(scene.camera, width_px, height_px, depthRange(scene.camera, model.get()));
  const Projection inside(scene.camera, width_px * samples, height_px * samples, projection.depth);
  Lighting lighting =
      lightingOf(scene, model.get(), model && !model->light.field.empty() ? &occlusion : nullptr, projection.depth);
  lighting.fine = options.fine_light;
  // A large picture is viewed as a whole, so its lines are scaled with it.
  const float line_scale = options.line_scale * std::max(1.0f, float(height_px) / 800.0f);
  if (!layer.draw(scene, model.get(), inside, lighting,
                  {samples, line_scale, options.outlines, options.occlusion_cull, options.fine_light,
                   options.wait_for_surfaces},
                  {resolve, spheres, meshes, wires}))
    return false;
  count.atoms_redrawn = layer.redrawn();
  count.surface_progress = layer.surfaceProgress();
  count.light_pending = light.busy();
  count.atoms_drawn = layer.atomsDrawn();
  // If the molecule is unchanged, only the present and previous areas of the glyphs change.
  const PixelBox whole{0, 0, width_px, height_px};
  const bool all = layer.redrawn() || !have_picture || picture.width() != width_px || picture.height() != height_px ||
                   last_options != options || last.blank;
  if (!picture.resize(width_px, height_px)) return false;
  if (samples > 1) {
    const bool made = flat.width() == width_px && flat.height() == height_px;
    if (!flat.resize(width_px, height_px)) return false;
    if (layer.redrawn() || !made) {
      flat.bind();
      resolve.layer(layer.target(), samples);
    }
  }
  if (const PixelBox part = all ? whole : glyph_box; !part.empty())
    copyPart(samples > 1 ? flat : layer.target(), picture, part, GL_COLOR_BUFFER_BIT);

  glyphs.clear();
  dots.clear();
  near.clear();
  if (model) addNearSpheres(scene, *model, near);
  if (model) addTouchedSpheres(scene, *model, near);
  addGlyphs(scene, model.get(), glyphs);
  addScanningTip(scene, glyphs.shell);
  if (model) addHapticShapes(scene, *model, glyphs.strokes, dots);
  PixelBoxBuilder around(projection);
  glyphs.addTo(around);
  for (const auto* list : {&dots, &near})
    for (const LooseSphere& s : *list) around.add(s.centre, s.radius);
  addRelief(scene, around);
  const PixelBox box = around.box(4 + int(8.0f * line_scale)), changed = glyph_box.joined(box);
  glyph_box = box;
  if (!box.empty()) {
    const GlTarget& on = samples > 1 ? large : picture;
    if (samples > 1 && !large.resize(inside.width_px, inside.height_px)) return false;
    const PixelBox fine = box.times(samples);
    copyPart(layer.target(), on, fine, GL_COLOR_BUFFER_BIT);
    copyPart(layer.opaque(), on, fine, GL_DEPTH_BUFFER_BIT);
    on.bind();
    glEnable(GL_SCISSOR_TEST);
    glScissor(fine.x0, fine.y0, fine.width(), fine.height());
    drawGlyphs(layer.opaque(), inside, lighting, line_scale * float(samples));
    if (samples > 1) {
      picture.bind();
      glScissor(box.x0, box.y0, box.width(), box.height());
      resolve.layer(large, samples);
    }
    glDisable(GL_SCISSOR_TEST);
  }
  filtered = samples == 1 && options.smooth_edges;
  if (filtered) {
    if (!smooth.resize(width_px, height_px)) return false;
    smoothEdges(changed, all, scene, projection);
  }
  return true;
}

// The background has no edges, and unchanged parts are already filtered.
void Renderer::Impl::smoothEdges(const PixelBox& changed, bool all, const ViewScene& scene,
                                 const Projection& projection) {
  const int width_px = picture.width(), height_px = picture.height();
  PixelBox part = changed.grown(EdgeFilter::kReach_px + 1, width_px, height_px);
  if (all) {
    if (model) {
      PixelBoxBuilder around(projection);
      around.add(glm::vec3(scene.camera.toView({model->middle_A})), float(model->reach_A + kBeyondSpheres_A));
      part = part.joined(around.box(EdgeFilter::kReach_px + 1));
    }
    copyPart(picture, smooth, {0, 0, width_px, height_px}, GL_COLOR_BUFFER_BIT);
  }
  if (part.empty()) return;
  smooth.bind();
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.x0, part.y0, part.width(), part.height());
  filter.draw(picture);
  glDisable(GL_SCISSOR_TEST);
}

std::optional<Problem> Renderer::draw(const ViewScene& scene, int width_px, int height_px,
                                      const RenderOptions& options) {
  Impl& p = *impl_;
  const auto tooLarge = [&] {
    p.forget();
    return Problem{
        .file = {},
        .message = trf("a picture of {0} x {1} pixels is refused by the graphics driver", width_px, height_px),
        .remedy = tr("ask for a smaller one")};
  };
  if (width_px < 1 || height_px < 1 || width_px > 16384 || height_px > 16384) return tooLarge();
  if (p.have_picture && p.picture.width() == width_px && p.picture.height() == height_px && p.last_options == options &&
      sameView(p.last, scene) && !p.layer.surfaceReady() && !p.light.done()) {
    p.count.atoms_redrawn = false;
    p.count.surface_progress = p.layer.surfaceProgress();
    p.count.light_pending = p.light.busy();
    return std::nullopt;
  }
  // Ignores earlier errors of other code; the limit is for a lost context, which reports errors for ever.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
    if (i == 15)
      return Problem{
          .file = {}, .message = tr("the graphics context is lost"), .remedy = tr("start the program again")};
  const CallersState state;
  const bool alike = p.model && p.model->max_single == scene.max_single_atoms;
  const bool moved = alike && p.model->molecule != scene.molecule && p.model->moveTo(scene.molecule);
  const bool other = !alike || p.model->molecule != scene.molecule;
  if (other)
    p.model = scene.molecule && !scene.molecule->atoms.empty()
                  ? std::make_unique<MoleculeModel>(scene.molecule, scene.max_single_atoms)
                  : nullptr;
  p.findLight(scene, other || p.model->hidden != scene.look.hidden || (moved && options.wait_for_surfaces), moved);
  if (p.model) {
    AtomPaint paint{.elements = scene.elements,
                    .by = scene.colour_by,
                    .colouring = scene.look.colouring,
                    .marks = scene.look.marks,
                    .touched = scene.touched,
                    .touched_colour = scene.theme.touched};
    if (paint != p.model->paint_used) p.model->paint(std::move(paint));
  }
  p.count.atoms = p.model ? p.model->spheres.size() : 0;
  if (scene.blank) {
    if (!p.picture.resize(width_px, height_px)) return tooLarge();
    p.filtered = false;
    p.picture.bind();
    glClearColor(0.02f, 0.02f, 0.025f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  } else if (!p.drawScene(scene, width_px, height_px, options)) {
    return tooLarge();
  }
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    p.forget();
    return Problem{.file = {},
                   .message = trf("the graphics driver reports error {0} while drawing", error),
                   .remedy = tr("LIBGL_ALWAYS_SOFTWARE=1 uses the software driver")};
  }
  p.last = scene;
  p.last_options = options;
  p.have_picture = true;
  ++p.count.pictures;
  return std::nullopt;
}

unsigned Renderer::textureId() const { return impl_->shown().colour(); }

void Renderer::copyTo(int x_px, int y_px) const {
  const GlTarget& from = impl_->shown();
  GLint read = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer());
  glBlitFramebuffer(0, 0, from.width(), from.height(), x_px, y_px, x_px + from.width(), y_px + from.height(),
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read));
}

Picture Renderer::readPixels() const {
  const GlTarget& from = impl_->shown();
  Picture picture{from.width(), from.height(), {}};
  // RGBA is supported by every driver.
  std::vector<std::uint8_t> rgba(std::size_t(4) * from.width() * from.height());
  GLint read = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, from.width(), from.height(), GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read));
  picture.rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t k = 0; k < rgba.size(); k += 4)
    picture.rgb.insert(picture.rgb.end(), {rgba[k], rgba[k + 1], rgba[k + 2]});
  const std::size_t row = std::size_t(3) * from.width();
  for (int y = 0; y < from.height() / 2; ++y)
    std::swap_ranges(picture.rgb.begin() + std::ptrdiff_t(row * y), picture.rgb.begin() + std::ptrdiff_t(row * (y + 1)),
                     picture.rgb.end() - std::ptrdiff_t(row * (y + 1)));
  return picture;
}

void Renderer::finish() const {
#ifdef __EMSCRIPTEN__
  // WebGL's finish() does not block; reading a pixel does.
  GLint read = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->shown().framebuffer());
  std::uint8_t pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read));
#else
  glFinish();
#endif
}

void Renderer::invalidate() { impl_->forget(); }

const RenderCount& Renderer::count() const { return impl_->count; }

}  // namespace moltact
