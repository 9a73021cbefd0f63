#include "engine/render/renderer.h"

#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/render/glyphs.h"
#include "engine/render/haptic_shapes.h"
#include "engine/render/resolve.h"
#include "engine/render/solid_mesh.h"

namespace moltact {
namespace {

// Room round the molecule for the probe, the arrow and the HIP.
constexpr double kRoom_A = 30.0;

DepthRange depthRange(const Camera& camera, const MoleculeModel* model) {
  const PointA middle{model ? model->middle_A : camera.target.A};
  const double reach = (model ? model->reach_A : 0.0) + kRoom_A, depth = -camera.toView(middle).z;
  DepthRange range;
  range.near_A = std::max({depth - reach, 0.02 * camera.distance_A, 0.05});
  range.far_A = std::max(depth + reach, 2.0 * range.near_A);
  return range;
}

Lighting lightingOf(const ViewScene& scene, const MoleculeModel* model, const DepthRange& range) {
  Lighting lighting;
  lighting.background_top = scene.theme.background_top;
  lighting.background_bottom = scene.theme.background_bottom;
  lighting.rotation = glm::mat3(glm::transpose(glm::mat3_cast(scene.camera.orientation)));
  if (model && model->reach_A > 0) {
    const double depth = -scene.camera.toView({model->middle_A}).z;
    const double front = std::max(depth - model->reach_A, range.near_A), back = depth + model->reach_A;
    lighting.fade_from_A = float(front + 0.25 * (back - front));
    lighting.fade_over_A = float(std::max(1e-3, 0.75 * (back - front)));
    lighting.fade_most = float(scene.theme.fade * std::clamp((back - front) / 40.0, 0.15, 1.0));
  }
  return lighting;
}

// The width of the dark rims at depth 1: 1.3 pixels of the finished picture.
float rimOf(int samples, const Projection& inside) {
  return 1.3f * float(samples) * 2.0f * inside.tan_y / float(inside.height_px);
}

// Put back at the end of a picture, whatever happens in between.
class CallersState {
 public:
  CallersState() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
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
    if (scissor_) glEnable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }

 private:
  GLint draw_ = 0, read_ = 0, viewport_[4]{};
  GLboolean scissor_ = GL_FALSE;
};

// All that the layer of atoms depends on.
struct LayerKey {
  std::shared_ptr<const Molecule> molecule;
  ElementColours elements = ElementColours::Customary;
  ColourBy colour_by = ColourBy::Element;
  Camera camera;
  int width = 0, height = 0, samples = 0;
  bool outlines = false, cull = false, atoms = false, resolved = true;
  Colour top{0.0f}, bottom{0.0f}, tint{0.0f};
  std::vector<std::uint32_t> tinted;
  bool operator==(const LayerKey&) const = default;
};

}  // namespace

struct Renderer::Impl {
  Impl(SphereImpostors b, Wireframe w, SolidMesh m, Resolve r)
      : balls(std::move(b)), wires(std::move(w)), mesh(std::move(m)), resolve(std::move(r)) {}

  SphereImpostors balls;
  Wireframe wires;
  SolidMesh mesh;
  Resolve resolve;
  GlTarget raw, layer, picture;  // the atoms with all samples; the same at the picture's size; with everything on top
  GlTarget large;                // everything with all samples
  SphereCull cull;
  std::unique_ptr<MoleculeModel> model;
  Glyphs glyphs;
  std::vector<LooseSphere> dots;
  LayerKey key;
  ViewScene last;
  RenderOptions last_options;
  bool have_layer = false, have_picture = false;
  RenderCount count;

  bool drawLayer(const ViewScene& scene, const Projection& projection, const Lighting& lighting, LayerKey wanted);
  void drawGlyphs(const ViewScene& scene, const Projection& projection, const Lighting& lighting, float line_scale);
};

Renderer::Renderer() = default;
Renderer::~Renderer() = default;

Expected<std::unique_ptr<Renderer>> Renderer::create() {
  if (const int version = tooOldGl())
    return Problem{.file = {},
                   .message = trf("the graphics driver offers OpenGL {0}.{1}", version / 10, version % 10),
                   .remedy = tr("OpenGL 3.3 is needed; LIBGL_ALWAYS_SOFTWARE=1 uses the software driver")};
  auto balls = SphereImpostors::build();
  if (!balls) return balls.problem();
  auto wires = Wireframe::build();
  if (!wires) return wires.problem();
  auto mesh = SolidMesh::build();
  if (!mesh) return mesh.problem();
  auto resolve = Resolve::build();
  if (!resolve) return resolve.problem();
  std::unique_ptr<Renderer> made(new Renderer);
  made->impl_ = std::make_unique<Impl>(*std::move(balls), *std::move(wires), *std::move(mesh), *std::move(resolve));
  return {std::move(made)};
}

bool Renderer::Impl::drawLayer(const ViewScene& scene, const Projection& projection, const Lighting& lighting,
                               LayerKey wanted) {
  count.atoms_redrawn = !(have_layer && wanted == key);
  if (!count.atoms_redrawn) return true;
  have_layer = false;
  const int width = wanted.width * wanted.samples, height = wanted.height * wanted.samples;
  const bool direct = wanted.samples == 1;
  if ((wanted.resolved && !layer.resize(wanted.width, wanted.height)) || (!direct && !raw.resize(width, height)))
    return false;
  (direct ? layer : raw).bind();
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  resolve.background(lighting);
  count.atoms_drawn = 0;
  if (model && wanted.atoms) {
    const Projection inside(scene.camera, width, height, projection.depth);
    const float rim = wanted.outlines ? rimOf(wanted.samples, inside) : 0.0f;
    cull.run(model->scene, scene.camera, inside, rim, wanted.cull);
    count.atoms_drawn = cull.atomsDrawn();
    balls.drawMolecule(*model, cull.drawn(), wanted.tinted, packColour(wanted.tint), rim, inside, lighting);
  }
  if (wanted.resolved && !direct) {
    layer.bind();
    resolve.layer(raw, wanted.samples);
  }
  key = std::move(wanted);
  have_layer = true;
  return true;
}

void Renderer::Impl::drawGlyphs(const ViewScene& scene, const Projection& projection, const Lighting& lighting,
                                float line_scale) {
  glyphs.clear();
  dots.clear();
  addGlyphs(scene, model.get(), glyphs);
  if (model) addHapticShapes(scene, *model, glyphs.strokes, dots);

  // Ghosts first: they show only behind the atoms, and their own solid bodies must not count as hiding them.
  Lighting near = lighting;
  near.fade_most *= 0.4f;  // what the lesson is about does not drown in the distance
  balls.drawLoose(glyphs.ghost, SphereImpostors::Pass::Ghost, projection, near);
  for (const GlyphCone& c : glyphs.cones) mesh.addCone(c.a, c.b, c.radius_a, c.radius_b, c.colour);
  for (const GlyphModel& m : glyphs.models) mesh.addModel(*m.model, m.to_view);
  mesh.draw(projection, near, 0.35f);
  balls.drawLoose(glyphs.solid, SphereImpostors::Pass::Solid, projection, near);
  balls.drawLoose(dots, SphereImpostors::Pass::Solid, projection, near);
  wires.draw(glyphs.strokes, projection, line_scale);
  balls.drawLoose(glyphs.shell, SphereImpostors::Pass::Shell, projection, near);
}

std::optional<Problem> Renderer::draw(const ViewScene& scene, int width_px, int height_px,
                                      const RenderOptions& options) {
  Impl& p = *impl_;
  const auto tooLarge = [&] {
    p.have_layer = p.have_picture = false;
    return Problem{
        .file = {},
        .message = trf("a picture of {0} x {1} pixels is refused by the graphics driver", width_px, height_px),
        .remedy = tr("ask for a smaller one")};
  };
  if (width_px < 1 || height_px < 1 || width_px > 16384 || height_px > 16384) return tooLarge();
  if (p.have_picture && p.picture.width() == width_px && p.picture.height() == height_px && p.last_options == options &&
      sameView(p.last, scene)) {
    p.count.atoms_redrawn = false;
    return std::nullopt;
  }
  // Errors that others left behind are not this picture's; a lost context would report for ever.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
    if (i == 15)
      return Problem{
          .file = {}, .message = tr("the graphics context is lost"), .remedy = tr("start the program again")};
  const CallersState state;
  if (!p.model || p.model->molecule != scene.molecule)
    p.model =
        scene.molecule && !scene.molecule->atoms.empty() ? std::make_unique<MoleculeModel>(scene.molecule) : nullptr;
  if (p.model && (p.model->elements != scene.elements || p.model->colour_by != scene.colour_by))
    p.model->paint(scene.elements, scene.colour_by);
  p.count.atoms = p.model ? p.model->scene.size() : 0;
  if (!p.picture.resize(width_px, height_px)) return tooLarge();

  if (scene.blank) {
    p.picture.bind();
    glClearColor(0.02f, 0.02f, 0.025f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  } else {
    const Projection projection(scene.camera, width_px, height_px, depthRange(scene.camera, p.model.get()));
    const Lighting lighting = lightingOf(scene, p.model.get(), projection.depth);
    LayerKey key{.molecule = scene.molecule,
                 .elements = scene.elements,
                 .colour_by = scene.colour_by,
                 .camera = scene.camera,
                 .width = width_px,
                 .height = height_px,
                 .samples = std::clamp(options.samples, 1, 4),
                 .outlines = options.outlines,
                 .cull = options.occlusion_cull,
                 .atoms = scene.shown.has(ViewPart::Atoms),
                 .top = scene.theme.background_top,
                 .bottom = scene.theme.background_bottom,
                 .tint = scene.theme.target,
                 .tinted = {}};
    if (scene.shown.has(ViewPart::Target)) key.tinted = scene.highlighted;
    std::sort(key.tinted.begin(), key.tinted.end());
    const int samples = key.samples;
    const bool all_smooth = options.smooth_glyphs && samples > 1;
    key.resolved = !all_smooth;
    if (!p.drawLayer(scene, projection, lighting, std::move(key))) return tooLarge();
    const int width = all_smooth ? width_px * samples : width_px, height = all_smooth ? height_px * samples : height_px;
    if (all_smooth && !p.large.resize(width, height)) return tooLarge();
    const GlTarget& from = all_smooth ? p.raw : p.layer;
    const GlTarget& to = all_smooth ? p.large : p.picture;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer());
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    to.bind();
    // A large picture is looked at whole: its lines grow with it.
    const float line_scale =
        options.line_scale * std::max(1.0f, float(height_px) / 800.0f) * float(height) / float(height_px);
    p.drawGlyphs(scene, Projection(scene.camera, width, height, projection.depth), lighting, line_scale);
    if (all_smooth) {
      p.picture.bind();
      p.resolve.layer(p.large, samples);
    }
  }
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    p.have_layer = p.have_picture = false;
    return Problem{.file = {},
                   .message = trf("the graphics driver reports error {0} while drawing", error),
                   .remedy = tr("LIBGL_ALWAYS_SOFTWARE=1 uses the software driver")};
  }
  p.last = scene;
  p.last_options = options;
  p.have_picture = true;
  return std::nullopt;
}

unsigned Renderer::textureId() const { return impl_->picture.colour(); }

void Renderer::copyTo(int x_px, int y_px) const {
  const GlTarget& from = impl_->picture;
  GLint read = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer());
  glBlitFramebuffer(0, 0, from.width(), from.height(), x_px, y_px, x_px + from.width(), y_px + from.height(),
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read));
}

Picture Renderer::readPixels() const {
  const GlTarget& from = impl_->picture;
  Picture picture{from.width(), from.height(), {}};
  // Red, green, blue and opacity are what every driver gives.
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
  // WebGL's finish() waits for nothing; what is read has been drawn.
  GLint read = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->picture.framebuffer());
  std::uint8_t pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read));
#else
  glFinish();
#endif
}

void Renderer::invalidate() { impl_->have_layer = impl_->have_picture = false; }

const RenderCount& Renderer::count() const { return impl_->count; }

}  // namespace moltact
