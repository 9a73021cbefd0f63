// The 3-D view as a texture for the view panel. The renderer draws only what has changed; this class decides at which
// quality. Window's thread, with the GL context current.
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
  /// With `wait`, each picture waits for its surfaces, so that every run draws the same.
  explicit ViewPicture(bool wait);
  ~ViewPicture();

  /// Draws the scene if it differs from the last one. `moving`: the view rotates, so speed takes precedence over
  /// sharpness. `line_scale`: that of the interface.
  void draw(const ViewScene& scene, int width_px, int height_px, bool moving, float line_scale);

  /// While on, draw() renders no picture. For frames of a script that are not shown.
  void hold(bool on) { held_ = on; }

  /// Null until the first picture.
  ImTextureID texture() const;
  /// Changes whenever a picture is drawn or stored.
  std::uint64_t version() const { return (renderer_ ? renderer_->count().pictures : 0) + fades_; }
  /// Stores the present picture, to fade it out over the following ones; does nothing before the first.
  void keepForFade();
  /// The picture stored last, or null.
  ImTextureID kept() const;
  /// Whether the picture is coarser than it will be once the view is at rest.
  bool unfinished() const {
    return fineness_.unfinished() || surfaceProgress() || (renderer_ && renderer_->count().light_pending);
  }
  /// The progress of a surface that is computed in the background, 0 to 1; no value if there is none.
  std::optional<float> surfaceProgress() const {
    return renderer_ ? renderer_->count().surface_progress : std::nullopt;
  }
  /// A picture for a file, at full quality; empty if the scene cannot be drawn.
  Picture take(const ViewScene& scene, int width_px, int height_px, float line_scale);
  /// The positions of the scene's names and measurements, recomputed after changes. `line_px`: height of the letters
  /// that `room` measures with.
  const std::vector<PlacedLabel>& labels(const ViewScene& scene, const SphereGrid* spheres, const LabelRoom& room,
                                         float line_px);
  /// The reason why the scene cannot be drawn; empty if it can.
  const std::string& fault() const { return fault_text_; }

 private:
  bool ready();

  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<GlTarget> kept_;
  int width_px_ = 0, height_px_ = 0;  // of the last picture drawn
  std::string fault_text_;
  const bool wait_;
  bool refused_ = false, held_ = false;
  std::uint64_t fades_ = 0;
  AdaptiveQuality fineness_;
  struct LabelKey {
    std::vector<std::shared_ptr<const Annotations>> annotations;
    std::shared_ptr<const Annotations> held_lines;
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

/// "moltact-001.png", or the first free number after that in the folder.
std::filesystem::path freePictureName(const std::filesystem::path& folder);

}  // namespace moltact
