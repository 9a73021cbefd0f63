// The 3-D view as a texture that the view panel shows. The renderer draws only what has changed; this decides how
// finely. Window's thread, with the GL
// context current.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "engine/render/adaptive_quality.h"
#include "engine/render/label_layout.h"
#include "engine/render/picture.h"
#include "engine/render/renderer.h"
#include "engine/render/view_scene.h"

namespace moltact {

class GlTarget;

class ViewPicture {
 public:
  /// With `wait` each picture has its surfaces, however long they take: every run draws the same.
  explicit ViewPicture(bool wait);
  ~ViewPicture();

  /// Draws the scene where it differs from the last one. `moving`: the view turns, so that speed counts more than
  /// sharpness. `line_scale`: the interface's.
  void draw(const ViewScene& scene, int width_px, int height_px, bool moving, float line_scale);

  /// Nobody looks at the next frames: draw() then does nothing but count them.
  void hold(bool on) { held_ = on; }

  /// Null until something has been drawn.
  ImTextureID texture() const;
  /// Another number whenever a picture was drawn or kept.
  std::uint64_t version() const { return (renderer_ ? renderer_->count().pictures : 0) + fades_; }
  /// Keeps the picture as it is, to fade away over the ones that follow; does nothing before the first.
  void keepForFade();
  /// The picture kept last; null where none is.
  ImTextureID kept() const;
  /// The picture shown is coarser than it will be once the view has rested.
  bool unfinished() const {
    return fineness_.unfinished() || surfaceProgress() || (renderer_ && renderer_->count().light_pending);
  }
  /// How far a surface is that is computed beside the window, 0 to 1; no value where none is.
  std::optional<float> surfaceProgress() const {
    return renderer_ ? renderer_->count().surface_progress : std::nullopt;
  }
  /// A picture to be kept, drawn as finely as pictures are; empty where the scene cannot be drawn.
  Picture take(const ViewScene& scene, int width_px, int height_px, float line_scale);
  /// Where the names and measures of the scene stand, worked out when something has changed. `line_px`: the height of the
  /// letters that `room` measures with.
  const std::vector<PlacedLabel>& labels(const ViewScene& scene, const SphereGrid* spheres, const LabelRoom& room,
                                         float line_px);
  /// Why the scene cannot be drawn; empty when it can.
  const std::string& fault() const { return fault_text_; }

 private:
  bool ready();

  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<GlTarget> kept_;
  int width_px_ = 0, height_px_ = 0;  // of the last picture as drawn
  std::string fault_text_;
  const bool wait_;
  bool refused_ = false, held_ = false;
  std::uint64_t fades_ = 0;
  AdaptiveQuality fineness_;
  struct LabelKey {
    std::vector<std::shared_ptr<const Annotations>> annotations;
    AtomsLook look;
    Camera camera;
    int width_px = 0, height_px = 0;
    double unit_px = 0.0;
    float line_px = 0.0f;
    friend bool operator==(const LabelKey&, const LabelKey&) = default;
  };
  LabelKey label_key_;
  std::vector<PlacedLabel> labels_;
};

/// "moltact-001.png" or the first number after that is free in the folder.
std::filesystem::path freePictureName(const std::filesystem::path& folder);

}  // namespace moltact
