// Smooth transitions between scenes: with the same molecule the camera glides, otherwise the old picture fades out over
// the new one. With reduced motion the change is immediate. Window's thread. Unit: second.
#pragma once

#include <memory>

#include "app/ui/application/extension.h"
#include "engine/render/camera.h"

namespace moltact {

struct Settings;
class ViewPicture;

struct Molecule;

/// The camera at the fraction `t` (0 to 1) of the path from `a` to `b`. The target moves on a straight line, the
/// rotation takes the shorter arc, the distance changes exponentially.
Camera between(const Camera& a, const Camera& b, double t);

class SceneChange : public Extension {
 public:
  SceneChange(HapticSession& scene, const Settings& settings, ViewPicture& picture, const FrameTime& time)
      : scene_(scene), settings_(settings), picture_(picture), time_(time) {}

  static constexpr double kGlide_s = 0.6, kFade_s = 0.35;

  void sceneChanged() override;
  void viewReset(const Camera& seen) override { glide(seen); }
  void beforeTicks() override;
  void afterPanels() override;
  bool live() const override { return glide_s_ < kGlide_s || fade_s_ < kFade_s; }

  /// Glides from the visible view to the scene's camera, which has already been set. Immediate with reduced motion.
  void glide(const Camera& seen);
  /// The destination of the camera's glide; `now` if there is none.
  Camera bound(const Camera& now) const { return gliding() ? to_ : now; }

  /// The opacity of the old picture over the new one (1 to 0).
  double oldPicture() const { return 1.0 - fade_s_ / kFade_s; }
  bool gliding() const { return glide_s_ < kGlide_s; }

 private:
  HapticSession& scene_;
  const Settings& settings_;
  ViewPicture& picture_;
  const FrameTime& time_;
  Camera seen_, from_, to_;
  std::shared_ptr<const Molecule> molecule_;  // of the previous frame
  double glide_s_ = kGlide_s, fade_s_ = kFade_s;
};

}  // namespace moltact
