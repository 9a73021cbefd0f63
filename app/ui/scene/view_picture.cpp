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

ViewPicture::ViewPicture(bool wait) : wait_(wait) {}
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
  const AdaptiveQuality::Choice choice = fineness_.choose(moving);
  if (held_ || width_px < 1 || height_px < 1 || !ready()) return;
  RenderOptions options = choice.options;
  options.wait_for_surfaces = wait_;
  options.line_scale = line_scale * float(choice.scale);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  const auto pixels = [&](int whole) { return std::max(1, int(std::lround(whole * choice.scale))); };
  width_px_ = pixels(width_px);
  height_px_ = pixels(height_px);
  if (const std::optional<Problem> problem = renderer_->draw(scene, width_px_, height_px_, options))
    fault_text_ = problem->text();
  else
    fault_text_.clear();
  if (!renderer_->count().atoms_redrawn) return;
  renderer_->finish();  // commands that were only queued have not been executed yet
  fineness_.took(std::chrono::duration<double, std::milli>(Clock::now() - begun).count());
}

void ViewPicture::keepForFade() {
  if (width_px_ < 1 || !ready()) return;
  if (!kept_) kept_ = std::make_unique<GlTarget>();
  GLint before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  if (kept_->resize(width_px_, height_px_)) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, kept_->framebuffer());
    renderer_->copyTo(0, 0);
    ++fades_;
  } else {
    kept_.reset();
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(before));
}

const std::vector<PlacedLabel>& ViewPicture::labels(const ViewScene& scene, const SphereGrid* spheres,
                                                    const LabelRoom& room, float line_px) {
  LabelKey key{scene.annotations, scene.held_lines, scene.look,   scene.camera,
               room.width_px,     room.height_px,   room.unit_px, line_px};
  if (key == label_key_) return labels_;
  label_key_ = std::move(key);
  return labels_ = layOutLabels(scene, spheres, room);
}

ImTextureID ViewPicture::kept() const { return textureOf(kept_ ? kept_->colour() : 0); }

ImTextureID ViewPicture::texture() const { return textureOf(renderer_ ? renderer_->textureId() : 0); }

Picture ViewPicture::take(const ViewScene& scene, int width_px, int height_px, float line_scale) {
  constexpr int kSamples = 3;
  if (!ready()) return {};
  RenderOptions options;
  options.wait_for_surfaces = wait_;
  options.line_scale = line_scale;
  for (options.samples = kSamples; options.samples > 0; --options.samples)  // as many samples as the driver supports
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
