#include "app/ui/scene/view_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "app/ui/widgets/imgui_versions.h"
#include "engine/language/catalogue.h"
#include "engine/render/gl_objects.h"

namespace moltact {
namespace {

constexpr double kMoving_ms = 18.0;   // the atoms may take so long in a frame while the view turns
constexpr double kSmooth_ms = 400.0;  // and so long, once, when it has come to rest
constexpr int kRest_frames = 10;
constexpr double kCoarsest = 0.5;

}  // namespace

ViewPicture::ViewPicture() = default;
ViewPicture::~ViewPicture() = default;

bool ViewPicture::ready() {
  if (renderer_ || refused_) return renderer_ != nullptr;
  Expected<std::unique_ptr<Renderer>> made = Renderer::create();
  if (made)
    renderer_ = std::move(*made);
  else {
    refused_ = true;
    fault_text_ = trf("The molecule cannot be drawn: {0}", made.problem().text());
  }
  return renderer_ != nullptr;
}

void ViewPicture::draw(const ViewScene& scene, int width_px, int height_px, bool moving, float line_scale) {
  rested_frames_ = moving ? 0 : rested_frames_ + 1;
  if (held_ || width_px < 1 || height_px < 1 || !ready()) return;
  // Cost goes with the number of pixels, the square of the scale; eighths keep it from flickering.
  double scale = 1.0;
  if (moving && whole_ms_ > kMoving_ms)
    scale = std::max(kCoarsest, std::floor(8.0 * std::sqrt(kMoving_ms / whole_ms_)) / 8.0);
  RenderOptions options;
  options.line_scale = line_scale * float(scale);
  const bool smooth = 4.0 * whole_ms_ < kSmooth_ms;
  if (!moving && smooth && (rested_frames_ >= kRest_frames || last_.samples == 2)) options.samples = 2;
  if (moving && whole_ms_ > 0 && 4.0 * whole_ms_ < kMoving_ms) options.samples = 2;
  unfinished_ = !moving && smooth && options.samples == 1 && whole_ms_ > 0;

  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  const auto pixels = [&](int whole) { return std::max(1, int(std::lround(whole * scale))); };
  width_px_ = pixels(width_px);
  height_px_ = pixels(height_px);
  if (const std::optional<Problem> problem = renderer_->draw(scene, width_px_, height_px_, options))
    fault_text_ = problem->text();
  else
    fault_text_.clear();
  if (renderer_->count().atoms_redrawn) {
    renderer_->finish();  // what has only been asked for has not been paid yet
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    const double whole = ms / (options.samples == 2 ? 4.0 : scale * scale);
    whole_ms_ = whole_ms_ > 0 ? 0.7 * whole_ms_ + 0.3 * whole : whole;
  }
  last_ = options;
}

void ViewPicture::keepForFade() {
  if (width_px_ < 1 || !ready()) return;
  if (!kept_) kept_ = std::make_unique<GlTarget>();
  GLint before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  if (kept_->resize(width_px_, height_px_)) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, kept_->framebuffer());
    renderer_->copyTo(0, 0);
  } else {
    kept_.reset();
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(before));
}

ImTextureID ViewPicture::kept() const { return textureOf(kept_ ? kept_->colour() : 0); }

ImTextureID ViewPicture::texture() const { return textureOf(renderer_ ? renderer_->textureId() : 0); }

Picture ViewPicture::take(const ViewScene& scene, int width_px, int height_px, float line_scale) {
  constexpr int kSamples = 3;
  if (!ready()) return {};
  RenderOptions options;
  options.line_scale = line_scale;
  for (options.samples = kSamples; options.samples > 0; --options.samples)  // as fine as the driver has room for
    if (!renderer_->draw(scene, width_px, height_px, options)) return renderer_->readPixels();
  return {};
}

std::filesystem::path freePictureName(const std::filesystem::path& folder) {
  for (int number = 1;; ++number) {
    char name[32];
    std::snprintf(name, sizeof name, "moltact-%03d.png", number);
    std::error_code error;
    if (!std::filesystem::exists(folder / name, error)) return folder / name;
  }
}

}  // namespace moltact
